#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

template <int D>
ParticleAtWall<D> at_wall(ParticleState<D>& particle) {
  return {particle.velocity, particle.spin, particle.mass, particle.radius, particle.inertia};
}

/// A particle hits a wall or an obstacle whose surface moves with `surface`; `normal` points into the gas. The TC model
/// makes the contact elastic.
template <int D>
void bounce(WallRule rule, const Vector<D>& normal, const Vector<D>& surface, ParticleState<D>& particle,
            Random& random) {
  if (particle.guarded) rule.surface.normal = {1, 0};
  reflect<D>(rule, normal, surface, at_wall(particle), random);
}

}  // namespace sandglass::event_driven
