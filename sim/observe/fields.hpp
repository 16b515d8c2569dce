#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Number density of real particles, velocity of the centre of mass and granular temperature in the bins of a regular grid.
/// Shape [bins of axis 0, ..., D + 2]; empty bins have zero velocity and temperature, and so has the temperature of one
/// particle.
template <int D>
class Fields final : public Observer<D> {
 public:
  explicit Fields(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  template <class All>
  std::vector<double> measure(const View<D>& view, const All& all) const;

  Lattice<D> bins_;
};

}  // namespace sandglass
