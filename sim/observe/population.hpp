#pragma once

#include "sim/base/exact_sum.hpp"
#include "sim/observe/view.hpp"

#include <algorithm>
#include <vector>

namespace sandglass {

/// Masses and moments of inertia in multiples of their unit, which is the particles' own: every one is 1, and multiplying
/// by it compiles to nothing.
struct OneSpecies {
  SpeciesTraits all;
  double mass_unit() const { return all.mass; }
  double inertia_unit() const { return all.inertia; }
  double mass(std::uint32_t) const { return 1; }
  double inertia(std::uint32_t) const { return 1; }
  const SpeciesTraits& traits(std::uint32_t) const { return all; }
  std::size_t index(std::uint32_t) const { return 0; }
};

/// Of a mixture; the units are 1.
struct SeveralSpecies {
  std::span<const std::uint8_t> species;
  std::span<const SpeciesTraits> list;
  static constexpr double mass_unit() { return 1; }
  static constexpr double inertia_unit() { return 1; }
  double mass(std::uint32_t i) const { return traits(i).mass; }
  double inertia(std::uint32_t i) const { return traits(i).inertia; }
  const SpeciesTraits& traits(std::uint32_t i) const { return list[species[i]]; }
  std::size_t index(std::uint32_t i) const { return species[i]; }
};

/// Real particles per simulated one, in multiples of `unit`.
struct OneWeight {
  double unit = 1;
  double operator()(std::uint32_t) const { return 1; }
};

/// Of the weight column; the unit is 1.
struct ManyWeights {
  static constexpr double unit = 1;
  std::span<const double> weights;
  double operator()(std::uint32_t i) const { return weights[i]; }
};

/// What the particles of a view are and how many real ones each stands for: all that an observer may ask beside the
/// phases. Sums count in the units of mass and weight.
template <class Kinds, class Weights>
struct Population : Kinds {
  Weights weight;
  double count = 0;       ///< sum of the weights
  double total_mass = 0;  ///< sum of weight times mass
  /// Degrees of freedom per axis of what is relative to the centre of mass. From <w m C^2> = w T (1 - w m / M), with M the
  /// sum of w m, it is the sum of w less that of w^2 m / M: N - 1 when the weights are alike.
  double freedom = 0;

  /// Mass of the real particles that particle i stands for.
  double real_mass(std::uint32_t i) const { return weight(i) * this->mass(i); }
  /// What turns a sum of real_mass() into a mass.
  double real_unit() const { return weight.unit * this->mass_unit(); }
};

template <class Kinds>
double mass_of_all(const Kinds&, std::size_t particles, Communicator*) {
  return static_cast<double>(particles);
}

/// By species, so that the sum depends on no order.
inline double mass_of_all(const SeveralSpecies& kinds, std::size_t, Communicator* ranks) {
  std::vector<std::uint64_t> count(256);
  for (std::uint8_t species : kinds.species) ++count[species];
  if (ranks != nullptr) count = sum_over(*ranks, count);
  double total = 0;
  for (std::size_t i = 0; i < kinds.list.size(); ++i)
    total += static_cast<double>(count[i]) * kinds.list[i].mass;
  return total;
}

template <class Kinds>
Population<Kinds, OneWeight> population_of(const Kinds& kinds, OneWeight weight, std::size_t particles,
                                           Communicator* ranks) {
  const auto count = static_cast<double>(particles);
  return {kinds, weight, count, mass_of_all(kinds, particles, ranks), std::max(count - 1, 1.0)};
}

template <class Kinds>
Population<Kinds, ManyWeights> population_of(const Kinds& kinds, ManyWeights weight, std::size_t particles) {
  ExactSum count, mass, squares;
  for (std::uint32_t i = 0; i < particles; ++i) {
    count.add(weight(i));
    mass.add(weight(i) * kinds.mass(i));
    squares.add(weight(i) * weight(i) * kinds.mass(i));
  }
  Population<Kinds, ManyWeights> all{kinds, weight, count.value(), mass.value(), 1};
  if (particles > 1) all.freedom = all.count - squares.value() / all.total_mass;
  return all;
}

/// Calls `use` with the population: two branches a sample, none a particle.
template <int D, class Use>
auto with_population(const View<D>& view, Use use) {
  const std::size_t particles = particles_of_all(view);
  const auto weights = view.columns.get(column::weight);
  const auto weighted = [&](const auto& kinds) {
    if (weights.empty()) return use(population_of(kinds, OneWeight{view.weight}, particles, view.ranks));
    return use(population_of(kinds, ManyWeights{weights}, particles));
  };
  const auto species = view.columns.get(column::species);
  const bool idle = view.ranks != nullptr && view.traits.size() > 1;  // without a particle there is no column
  if (species.empty() && !idle) return weighted(OneSpecies{view.traits.front()});
  return weighted(SeveralSpecies{species, view.traits});
}

}  // namespace sandglass
