#pragma once

#include "sim/observe/view.hpp"

#include <array>

namespace sandglass {

/// Masses of the particles in multiples of `unit`. With one species every mass is 1 and multiplying by it compiles to
/// nothing.
struct EqualMasses {
  double unit = 1, total = 0;
  double operator()(std::uint32_t) const { return 1; }
};

/// Masses of a mixture, with unit 1.
struct SpeciesMasses {
  static constexpr double unit = 1;
  double total = 0;
  std::span<const std::uint8_t> species;
  std::span<const SpeciesTraits> traits;
  double operator()(std::uint32_t i) const { return traits[species[i]].mass; }
};

template <int D>
SpeciesMasses species_masses(const View<D>& view) {
  std::array<std::uint64_t, 256> count{};
  for (std::uint8_t species : view.species) ++count[species];
  SpeciesMasses masses{0, view.species, view.traits};
  for (std::size_t i = 0; i < view.traits.size(); ++i)
    masses.total += static_cast<double>(count[i]) * view.traits[i].mass;
  return masses;
}

/// Calls `use` with the masses: one branch a sample, none a particle.
template <int D, class Use>
auto with_masses(const View<D>& view, Use use) {
  if (view.species.empty()) return use(EqualMasses{view.mass, static_cast<double>(view.particles.size())});
  return use(species_masses(view));
}

}  // namespace sandglass
