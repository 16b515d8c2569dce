#pragma once

#include "sim/method/dsmc/smooth_pairs.hpp"
#include "sim/method/dsmc/species_table.hpp"

namespace sandglass::dsmc {

/// Smooth particles of several species: cross-section, restitution and masses of each pair. Candidates are drawn for the
/// two widest particles of the cell.
template <int D>
class MixedPairs {
 public:
  struct Columns {
    Phase<D>* phases;
    const std::uint8_t* species;
    std::uint64_t* counts;
  };

  explicit MixedPairs(const Parameters& parameters) : table_(parameters) {
    for (const SpeciesTraits& kind : parameters.kinds.species) masses_.push_back(kind.mass);
  }

  Columns columns(const CollisionStep<D>& step, std::uint32_t first) const {
    return {step.particles + first, step.species + first, counts_by_species(*step.tally)};
  }
  double bound(const Columns& columns, std::uint32_t count, double speed) const {
    return table_.largest(columns.species, count) * speed;
  }
  std::uint64_t whole(double expected, Random& random) const {
    return static_cast<std::uint64_t>(expected + random.uniform());
  }
  bool accepts(const Columns& columns, const Pair& pair, double square_speed, double square_bound,
               double uniform) const {
    const double section = table_.pair(index(columns, pair)).cross_section;
    return uniform * uniform * square_bound < square_speed * section * section;
  }
  Vector<D - 1> impact(const Columns&, Random& random) const { return uniform_impact<D>(random); }
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    const std::size_t kinds = index(columns, pair);
    return apply(columns, pair, kinds,
                 smooth_kick(relative, square_speed, table_.pair(kinds).restitution, random));
  }
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    const std::size_t kinds = index(columns, pair);
    const Vector<D> relative = columns.phases[pair.first].velocity - columns.phases[pair.second].velocity;
    return apply(columns, pair, kinds,
                 -0.5 * (1 + table_.pair(kinds).restitution) * relative.dot(normal) * normal);
  }
  double transfer(const Columns& columns, const Pair& pair, const Vector<D>& displacement) const {
    const Phase<D>&one = columns.phases[pair.first], &two = columns.phases[pair.second];
    return (masses_[columns.species[pair.first]] * one.velocity -
            masses_[columns.species[pair.second]] * two.velocity)
        .dot(displacement);
  }

 private:
  std::size_t index(const Columns& columns, const Pair& pair) const {
    return table_.index(columns.species[pair.first], columns.species[pair.second]);
  }
  /// `kick` is the change that a pair of equal masses would take.
  Vector<D> apply(const Columns& columns, const Pair& pair, std::size_t kinds, const Vector<D>& kick) const {
    const PairOfSpecies& both = table_.pair(kinds);
    const Vector<D> change = both.share_1 * kick;
    columns.phases[pair.first].velocity += change;
    columns.phases[pair.second].velocity -= both.share_2 * kick;
    if (columns.counts != nullptr) ++columns.counts[kinds];
    return change;
  }

  SpeciesTable<D> table_;
  std::vector<double> masses_;
};

}  // namespace sandglass::dsmc
