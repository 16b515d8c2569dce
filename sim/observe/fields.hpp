#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Number density of real particles, mean velocity and granular temperature in the bins of a regular grid. Shape
/// [bins of axis 0, ..., D + 2]; empty bins have zero velocity and temperature, and so has the temperature of one particle.
template <int D>
class Fields final : public Observer<D> {
 public:
  explicit Fields(const ObserverSpec& spec) : spec_(spec) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  std::size_t bins() const;
  std::size_t bin_of(const Vector<D>& position, const Vector<D>& box) const;

  ObserverSpec spec_;
};

}  // namespace sandglass
