#pragma once

#include "sim/method/dsmc/species_pairs.hpp"

namespace sandglass::dsmc {

/// Smooth particles of several species: cross-section, restitution and masses of each pair.
template <int D>
class MixedPairs : public SpeciesPairs<D> {
 public:
  struct Columns {
    Phase<D>* phases;
    const std::uint8_t* species;
    std::uint64_t* counts;
    std::uint8_t kind(std::uint32_t particle) const { return species[particle]; }
  };

  using SpeciesPairs<D>::SpeciesPairs;

  Columns columns(const CollisionStep<D>& step, std::uint32_t cell) const {
    const std::uint32_t first = step.offsets[cell];
    return {step.particles + first, step.species + first, counts_by_species(*step.tally)};
  }
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    const std::size_t kinds = this->index(columns, pair);
    return apply(columns, pair, kinds,
                 smooth_kick(relative, square_speed, this->table_.pair(kinds).restitution, random));
  }
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    const std::size_t kinds = this->index(columns, pair);
    const Vector<D> relative = columns.phases[pair.first].velocity - columns.phases[pair.second].velocity;
    return apply(columns, pair, kinds,
                 -0.5 * (1 + this->table_.pair(kinds).restitution) * relative.dot(normal) * normal);
  }

 private:
  /// `kick` is the change that a pair of equal masses would take.
  Vector<D> apply(const Columns& columns, const Pair& pair, std::size_t kinds, const Vector<D>& kick) const {
    const PairOfSpecies& both = this->table_.pair(kinds);
    const Vector<D> change = both.share_1 * kick;
    columns.phases[pair.first].velocity += change;
    columns.phases[pair.second].velocity -= both.share_2 * kick;
    if (columns.counts != nullptr) ++columns.counts[kinds];
    return change;
  }
};

}  // namespace sandglass::dsmc
