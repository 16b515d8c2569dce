#pragma once

#include "sim/method/dsmc/species_pairs.hpp"

namespace sandglass::dsmc {

/// Particles with spin, of one species or several: the collision rule of sim/physics/contact.hpp, with tangential
/// restitution and friction.
template <int D>
class RoughPairs : public SpeciesPairs<D> {
 public:
  struct Columns {
    Phase<D>* phases;
    const std::uint8_t* species;  ///< null: one only
    Spin<D>* spins;
    std::uint64_t* counts;
    std::uint8_t kind(std::uint32_t particle) const { return species == nullptr ? 0 : species[particle]; }
  };

  explicit RoughPairs(const Parameters& parameters)
      : SpeciesPairs<D>(parameters), surfaces_(parameters.kinds.surfaces) {}

  Columns columns(const CollisionStep<D>& step, std::uint32_t cell) const {
    const std::uint32_t first = step.offsets[cell];
    return {step.particles + first, step.species == nullptr ? nullptr : step.species + first,
            step.spins + first, counts_by_species(*step.tally)};
  }
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    return strike(columns, pair,
                  contact_normal(relative, 1 / std::sqrt(square_speed), this->impact(columns, random)));
  }
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    const std::size_t kinds = this->index(columns, pair);
    const Partner<D> one = partner(columns, pair.first), two = partner(columns, pair.second);
    const Vector<D> before = one.velocity;
    sandglass::collide<D>(surfaces_[kinds], normal, one, two);
    if (columns.counts != nullptr) ++columns.counts[kinds];
    return (one.velocity - before).dot(normal) * normal;
  }

 private:
  Partner<D> partner(const Columns& columns, std::uint32_t i) const {
    const SpeciesTraits& kind = this->species_[columns.kind(i)];
    return {columns.phases[i].velocity, columns.spins[i], 1 / kind.mass, 1 / kind.inertia, kind.diameter / 2};
  }

  std::vector<Surface> surfaces_;
};

}  // namespace sandglass::dsmc
