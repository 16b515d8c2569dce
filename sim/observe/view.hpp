#pragma once

#include "sim/observe/plane.hpp"
#include "sim/observe/tally.hpp"
#include "sim/space/particle_store.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// What the particles of one species have in common.
struct SpeciesTraits {
  double diameter = 1;
  double mass = 1;
  double inertia = 0;  ///< moment of inertia
};

/// What an observer sees of a simulation at the end of a step.
template <int D>
struct View {
  std::span<const Phase<D>> particles;     ///< sorted by cell
  std::span<const std::uint32_t> offsets;  ///< first particle of each cell, and the end
  std::span<const Spin<D>> spins;          ///< angular velocities; empty for smooth particles
  std::span<const std::uint8_t> species;   ///< index into `traits`; empty when there is one species
  std::span<const SpeciesTraits> traits;
  Vector<D> box = Vector<D>::Zero();
  double mass = 1;    ///< of the first species
  double weight = 1;  ///< real particles per simulated one
  std::uint64_t step = 0;
  double time = 0;
  const Tally* tally = nullptr;
  std::vector<Plane>* planes = nullptr;
};

}  // namespace sandglass
