#pragma once

#include "sim/method/dsmc/smooth_pairs.hpp"
#include "sim/method/dsmc/species_table.hpp"

namespace sandglass::dsmc {

/// Particles with spin, of one species or several: the collision rule of sim/physics/contact.hpp, with tangential
/// restitution and friction.
template <int D>
class RoughPairs {
 public:
  struct Columns {
    Phase<D>* phases;
    const std::uint8_t* species;  ///< null: one only
    Spin<D>* spins;
    std::uint64_t* counts;
    std::uint8_t kind(std::uint32_t particle) const { return species == nullptr ? 0 : species[particle]; }
  };

  explicit RoughPairs(const Parameters& parameters)
      : table_(parameters), species_(parameters.kinds.species), surfaces_(parameters.kinds.surfaces) {}

  Columns columns(const CollisionStep<D>& step, std::uint32_t first) const {
    return {step.particles + first, step.species == nullptr ? nullptr : step.species + first,
            step.spins + first, counts_by_species(*step.tally)};
  }
  double bound(const Columns& columns, std::uint32_t count, double speed) const {
    return columns.species == nullptr ? speed : table_.largest(columns.species, count) * speed;
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
    return strike(columns, pair,
                  contact_normal(relative, 1 / std::sqrt(square_speed), impact(columns, random)));
  }
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    const std::size_t kinds = index(columns, pair);
    const Partner<D> one = partner(columns, pair.first), two = partner(columns, pair.second);
    const Vector<D> before = one.velocity;
    sandglass::collide<D>(surfaces_[kinds], normal, one, two);
    if (columns.counts != nullptr) ++columns.counts[kinds];
    return (one.velocity - before).dot(normal) * normal;
  }
  double transfer(const Columns& columns, const Pair& pair, const Vector<D>& displacement) const {
    const Phase<D>&one = columns.phases[pair.first], &two = columns.phases[pair.second];
    return (species_[columns.kind(pair.first)].mass * one.velocity -
            species_[columns.kind(pair.second)].mass * two.velocity)
        .dot(displacement);
  }

 private:
  std::size_t index(const Columns& columns, const Pair& pair) const {
    return table_.index(columns.kind(pair.first), columns.kind(pair.second));
  }
  Partner<D> partner(const Columns& columns, std::uint32_t i) const {
    const SpeciesTraits& kind = species_[columns.kind(i)];
    return {columns.phases[i].velocity, columns.spins[i], 1 / kind.mass, 1 / kind.inertia, kind.diameter / 2};
  }

  SpeciesTable<D> table_;
  std::vector<SpeciesTraits> species_;
  std::vector<Surface> surfaces_;
};

}  // namespace sandglass::dsmc
