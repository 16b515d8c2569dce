#pragma once

#include "sim/method/dsmc/expected_pairs.hpp"
#include "sim/physics/mixture_contact_value.hpp"
#include "sim/space/window_sum.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sandglass::dsmc {

/// Contact factors of every cell of a mixture, one for each pair of species, from the local densities of all species: what
/// LocalContactFactor is for one, and free of the same two biases. Where the pairs of a cell are those expected by chance,
/// times their factor.
template <int D>
class MixtureContactFactor {
 public:
  MixtureContactFactor(const Parameters& parameters, const LatticeOfCells<D>& cells,
                       const std::array<bool, D>& periodic, double particles);

  /// As WindowSum::set_volumes.
  void set_volumes(std::span<const double> volumes);
  /// `offsets` as of ParticleStore, `species` of each particle.
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work, const std::uint8_t* species);
  /// The largest of each cell.
  const double* values() const { return largest_.data(); }
  /// All in units of the largest, of species a with species b at [(cell * species + a) * species + b].
  const double* shares() const { return shares_.data(); }
  std::size_t bytes() const;

 private:
  void count(std::span<const std::uint32_t> offsets, const SharedCells& work, const std::uint8_t* species);
  void update_cell(std::uint32_t cell);
  double of_pair(std::uint32_t cell, std::size_t first, std::size_t second) const;
  double contact(std::uint32_t cell, std::size_t first, std::size_t second) const;

  bool dense_;     ///< there is a formula
  int dimension_;  ///< of it
  bool smoothed_;
  bool of_largest_;       ///< planted fault: all pairs have the largest
  std::uint32_t fewest_;  ///< particles of a cell whose factors anybody reads
  double densest_;
  std::vector<double> diameters_;
  std::vector<Crowding> crowding_;     ///< of one particle of each species in one whole cell
  std::vector<WindowSum<D>> windows_;  ///< particles of each species
  std::optional<ExpectedPairsOfSpecies<D>> expected_;
  std::vector<double> largest_, shares_;
};

extern template class MixtureContactFactor<2>;
extern template class MixtureContactFactor<3>;

}  // namespace sandglass::dsmc
