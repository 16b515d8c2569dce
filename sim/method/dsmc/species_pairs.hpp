#pragma once

#include "sim/method/dsmc/pair_rule.hpp"
#include "sim/method/dsmc/species_table.hpp"

namespace sandglass::dsmc {

/// What rules for several species share: cross-section and masses of each pair. Candidates are drawn for the two widest
/// particles of the cell. Columns of such a rule have `phases`, `species`, null where there is one only, and kind(), the
/// species of a particle.
template <int D>
class SpeciesPairs : public PairRule<D> {
 public:
  explicit SpeciesPairs(const Parameters& parameters)
      : table_(parameters), species_(parameters.kinds.species) {}

  template <class Columns>
  double bound(const Columns& columns, std::uint32_t count, double speed) const {
    return columns.species == nullptr ? speed : table_.largest(columns.species, count) * speed;
  }
  template <class Columns>
  bool accepts(const Columns& columns, const Pair& pair, double square_speed, double square_bound,
               double uniform) const {
    const double section = table_.pair(index(columns, pair)).cross_section;
    return uniform * uniform * square_bound < square_speed * section * section;
  }
  template <class Columns>
  double rate(const Columns& columns, const Pair& pair, double speed) const {
    return speed * table_.pair(index(columns, pair)).cross_section;
  }
  /// `shift` is the offset of Parameters; the centre of mass stays where it is.
  template <class Columns>
  void displace(const Columns& columns, const Pair& pair, const Vector<D>& shift) const {
    const PairOfSpecies& both = table_.pair(index(columns, pair));
    columns.phases[pair.first].position += both.offset * both.share_1 * shift;
    columns.phases[pair.second].position -= both.offset * both.share_2 * shift;
  }
  template <class Columns>
  double transfer(const Columns& columns, const Pair& pair, const Vector<D>& shift) const {
    const PairOfSpecies& both = table_.pair(index(columns, pair));
    const Phase<D>&one = columns.phases[pair.first], &two = columns.phases[pair.second];
    return both.offset * both.twice_reduced_mass * (one.velocity - two.velocity).dot(shift);
  }

 protected:
  template <class Columns>
  std::size_t index(const Columns& columns, const Pair& pair) const {
    return table_.index(columns.kind(pair.first), columns.kind(pair.second));
  }

  SpeciesTable<D> table_;
  std::vector<SpeciesTraits> species_;
};

}  // namespace sandglass::dsmc
