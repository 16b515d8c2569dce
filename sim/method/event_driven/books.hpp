#pragma once

#include "sim/method/event_driven/particle_state.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

// What particles and the sides of the box give each other, where no wall stands. Null: nobody counts.

/// What comes in takes from the side what going out gives it.
template <int D>
void note_newcomer(WallImpulses<D>* impulses, std::size_t side, const SpeciesTraits& traits,
                   Newcomer<D> newcomer) {
  if (impulses == nullptr) return;
  const ParticleAtWall<D> particle{newcomer.velocity, &newcomer.spin, traits.mass, traits.diameter / 2,
                                   traits.inertia};
  impulses->add(side, -traits.mass * newcomer.velocity, Vector<D>::Zero(),
                -energy_beside<D>(Vector<D>::Zero(), particle));
}

/// A side, or what stands before it, has changed the velocity of a particle from `before`.
template <int D>
void note_change(WallImpulses<D>* impulses, std::size_t side, const ParticleState<D>& particle,
                 const Vector<D>& before) {
  if (impulses == nullptr) return;
  impulses->add(side, particle.mass * (before - particle.velocity), Vector<D>::Zero(),
                particle.mass * (before.squaredNorm() - particle.velocity.squaredNorm()) / 2);
}

}  // namespace sandglass::event_driven
