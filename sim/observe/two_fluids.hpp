#pragma once

#include "sim/observe/lattice.hpp"
#include "sim/observe/observer.hpp"

#include <array>

// Two fluids as an observer sees them: the particles of the first species, and all others.

namespace sandglass {

/// Number density of the real particles of each fluid in the bins of a regular grid. Shape [bins of axis 0, ..., 2].
template <int D>
class FluidDensity final : public Observer<D> {
 public:
  explicit FluidDensity(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  Lattice<D> bins_;
};

/// Mean position of the real particles of each fluid. Shape [2, axes]; zero for a fluid without particles.
template <int D>
class FluidCentre final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
};

/// Lacey's index (1954) over the bins of a grid, M = (s_0^2 - s^2)/(s_0^2 - s_r^2): s^2 is the variance of the share of
/// the first fluid, by particles, s_0^2 = p (1 - p) that of separate fluids, and s_r^2 = p (1 - p) (C - 1)/(N - 1) the
/// mean of N particles dealt out at random over the C bins that hold any. 0 separate, 1 random; above 1 when more even
/// than chance. 0 where no bin holds two particles or there is one fluid only.
template <int D>
class MixingIndex final : public Observer<D> {
 public:
  explicit MixingIndex(const ObserverSpec& spec) : bins_{spec.grid} {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  Lattice<D> bins_;
};

/// From the number of simulated particles of each fluid in each bin.
double mixing_index(const std::vector<std::array<double, 2>>& bins);

}  // namespace sandglass
