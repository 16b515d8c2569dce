#pragma once

#include "sim/method/dsmc/collision_stage.hpp"

#include <vector>

namespace sandglass::dsmc {

/// How two species collide.
struct PairOfSpecies {
  double cross_section;  ///< in units of Parameters::cross_section
  double restitution;
  double share_1,
      share_2;  ///< twice the reduced mass over the mass of the first and the second: 1 for equal masses
  double twice_reduced_mass;
  double offset;  ///< in units of Parameters::offset
};

/// All pairs of the species of a mixture.
template <int D>
class SpeciesTable {
 public:
  explicit SpeciesTable(const Parameters& parameters);

  std::size_t index(std::uint8_t first, std::uint8_t second) const { return first * species_ + second; }
  std::size_t species() const { return species_; }
  std::size_t pairs() const { return pairs_.size(); }
  const PairOfSpecies& pair(std::size_t index) const { return pairs_[index]; }
  /// Largest cross-section of a pair among these particles, at least two: that of the two widest.
  double largest(const std::uint8_t* species, std::uint32_t count) const;
  /// The same of a particle of this species with any other.
  double largest(std::uint8_t species) const;

 private:
  std::size_t species_;
  std::vector<double> widths_;  ///< diameters in units of the largest
  std::vector<PairOfSpecies> pairs_;
};

extern template class SpeciesTable<2>;
extern template class SpeciesTable<3>;

/// Where collisions are counted by pair of species (Tally::by_species); null where nobody asks.
inline std::uint64_t* counts_by_species(Tally& tally) {
  return tally.by_species.empty() ? nullptr : tally.by_species.data();
}

}  // namespace sandglass::dsmc
