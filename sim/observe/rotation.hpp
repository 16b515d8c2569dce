#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Throws InputError, with the name of the observer that asks, where particles have no spin.
template <int D>
void require_spins(const View<D>& view, const std::string& observer);

/// Rotational energy sum I w^2 / 2 of all real particles.
template <int D>
class RotationalEnergy final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  void start(const View<D>& view) override;
};

/// Rotational granular temperature <I w^2> per degree of freedom: one for disks, three for spheres. No mean is taken off.
template <int D>
class RotationalTemperature final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  void start(const View<D>& view) override;
};

}  // namespace sandglass
