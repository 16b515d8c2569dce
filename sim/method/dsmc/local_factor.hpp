#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/space/particle_store.hpp"
#include "sim/space/window_sum.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace sandglass::dsmc {

/// Area or volume of one particle.
inline double particle_volume(int dimension, double diameter) {
  return dimension == 2 ? M_PI / 4 * diameter * diameter : M_PI / 6 * std::pow(diameter, 3);
}

/// Close packing: no formula is asked for more.
inline double densest_fraction(int dimension) { return M_PI / std::sqrt(dimension == 2 ? 12.0 : 18.0); }

/// Particles that a window holds at least. It scatters less than chance where offsets or partners at contact push particles
/// apart, which takes about one in its number from the rate: where little else is missing, a larger one is worth it.
constexpr double kWindow = 100, kLargeWindow = 400;
inline double window_particles(const Parameters& parameters) {
  const bool large = parameters.pair_count == PairCount::expected || parameters.partners == Partners::contact;
  return large ? kLargeWindow : kWindow;
}

/// Cells across the window that the smoothed density is read from, as `parameters` says; else so many that they hold
/// window_particles() where `particles` are spread evenly over the box. Of cells on a corner, their half diagonals.
template <int D>
std::uint32_t window_cells(const Parameters& parameters, const LatticeOfCells<D>& cells, double particles);

/// Contact factor of every cell from the local density.
///
/// A small cell's own count is a biased measure of the density around a pair: a pair sits more often where many
/// particles are (the count seen by a pair is larger by two), and the factor is convex (g of a fluctuating count
/// exceeds g of its mean). Here the density comes from a window of cells without the pair itself,
/// which for Poisson counts removes the first bias exactly, and the second derivative of the formula times the Poisson
/// variance removes the second to the second order. In full cells (see FullCells) moves are refused, and their numbers
/// scatter less than by chance or not at all: there neither bias is taken out.
template <int D>
class LocalContactFactor {
 public:
  LocalContactFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                     const std::array<bool, D>& periodic, double particles);

  /// As WindowSum::set_volumes.
  void set_volumes(std::span<const double> volumes) { window_.set_volumes(volumes); }
  /// `full`: per cell, not zero where it is full; null where none is.
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work,
              const std::uint8_t* full = nullptr);
  const double* values() const { return factor_.data(); }
  std::size_t bytes() const { return factor_.capacity() * sizeof(double) + window_.bytes(); }

 private:
  /// Without the two biases where counts scatter by chance, else that of the density as it is.
  [[gnu::always_inline]] inline double value(std::uint32_t cell, bool scatters) const;

  ContactFormula formula_;
  bool smoothed_;
  double fraction_per_particle_;  ///< area or volume fraction that one particle adds to one whole cell
  double densest_;
  WindowSum<D> window_;
  std::vector<double> factor_;
};

extern template class LocalContactFactor<2>;
extern template class LocalContactFactor<3>;

}  // namespace sandglass::dsmc
