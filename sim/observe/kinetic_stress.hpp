#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

namespace sandglass {

/// Kinetic part of the pressure tensor, P_ab = n m <C_a C_b>, in the bins of a regular grid, with C relative to the mean
/// velocity of the bin. Its trace is D n T with the density and temperature that Fields shows, its own degrees of freedom
/// taken off likewise. Shape [bins of axis 0, ..., D (D + 1) / 2]; 0 in bins of fewer than two particles. A gradient of the
/// velocity across a bin adds to it: bins are to be thin.
template <int D>
class KineticStress final : public Observer<D> {
 public:
  explicit KineticStress(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  template <class All>
  std::vector<double> measure(const View<D>& view, const All& all) const;

  Lattice<D> bins_;
};

}  // namespace sandglass
