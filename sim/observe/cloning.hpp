#pragma once

#include "sim/observe/cloning_sums.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Sums over all crossings between regions since time zero. The mean of what is gained is zero; its spread is the noise
/// that weights by region add.
template <int D>
class Cloning final : public Observer<D> {
 public:
  using Kind = typename CloningSums<D>::Kind;
  explicit Cloning(Kind kind) : kind_(kind) {}

  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool cumulative() const override { return true; }
  /// Throws InputError for a method without regions.
  void start(const View<D>& view) override;

 private:
  Kind kind_;
};

extern template class Cloning<2>;
extern template class Cloning<3>;

}  // namespace sandglass
