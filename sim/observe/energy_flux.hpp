#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Flux of the kinetic energy that particles carry with them in the bins of a regular grid, n <m v^2 v>/2; what contacts
/// hand over across a diameter is not in it, nor are spins. In a gas at rest it is the heat flux. A sum over particles: no
/// bias in small bins. Shape [bins of axis 0, ..., D].
template <int D>
class EnergyFlux final : public Observer<D> {
 public:
  explicit EnergyFlux(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  Lattice<D> bins_;
};

}  // namespace sandglass
