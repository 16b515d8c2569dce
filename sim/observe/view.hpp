#pragma once

#include "sim/base/columns.hpp"
#include "sim/base/communicator.hpp"
#include "sim/base/particle_columns.hpp"
#include "sim/observe/plane.hpp"
#include "sim/observe/tally.hpp"
#include "sim/observe/wall_impulses.hpp"
#include "sim/space/phase.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// What the particles of one species have in common.
struct SpeciesTraits {
  double diameter = 1;
  double mass = 1;
  double inertia = 0;  ///< moment of inertia
};

/// Of particles that nobody describes.
inline constexpr SpeciesTraits kUnitTraits{};

/// What an observer sees of a simulation at the end of a step.
template <int D>
struct View {
  std::span<const Phase<D>> particles;     ///< sorted by cell
  std::span<const std::uint32_t> offsets;  ///< first particle of each cell, and the end
  ColumnViews columns;                     ///< whatever else the particles have
  std::span<const SpeciesTraits> traits{&kUnitTraits,
                                        1};  ///< of each species; one entry without a species column
  Vector<D> box = Vector<D>::Zero();
  double weight = 1;  ///< real particles per simulated one, unless there is a weight column
  std::uint64_t step = 0;
  double time = 0;
  const Tally* tally = nullptr;
  std::vector<Plane>* planes = nullptr;
  const WallImpulses<D>* walls = nullptr;  ///< null: not counted
  /// Ranks that have the particles between them, of which the view shows those of one: sums are then over all. Null: it
  /// shows all.
  Communicator* ranks = nullptr;
};

/// Also those that other ranks have.
template <int D>
std::uint64_t particles_of_all(const View<D>& view) {
  const std::uint64_t own = view.particles.size();
  return view.ranks == nullptr ? own : sum_over(*view.ranks, {own}).front();
}

}  // namespace sandglass
