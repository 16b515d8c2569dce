#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Free surface h of a heap or a bed: the largest coordinate along `axis` of the centres over each bin of the other axes
/// (Müller 2001, section 3.5). Bins without a particle show 0, the low side of the box.
template <int D>
class FreeSurface final : public Observer<D> {
 public:
  /// Reads `axis` and `grid`, which has one bin along the axis. Throws InputError for more.
  explicit FreeSurface(const ObserverSpec& spec);
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  int axis_;
  Lattice<D> bins_;
};

}  // namespace sandglass
