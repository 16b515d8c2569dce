#pragma once

#include "sim/base/random.hpp"
#include "sim/base/vector.hpp"
#include "sim/physics/contact.hpp"

namespace sandglass {

/// What happens to a particle at a wall or a fixed obstacle, in the frame of its surface.
enum class WallKind {
  specular,     ///< the collision rule; a rough surface acts on particles that have spin
  bounce_back,  ///< every component is reversed (roughness of a pipe or a shear cell, Mueller 2001)
  random_tangential_sign,  ///< granular no-slip (Baryshev 2003)
  thermal,                 ///< leaves as from a gas at rest at the temperature of the wall
};

/// The normal component takes the normal restitution of the surface, save at a thermal wall. Only the specular kind acts
/// along the surface through tangential restitution and friction; it and the thermal kind alone change spins.
struct WallRule {
  WallKind kind = WallKind::specular;
  Surface surface = {};
  double probability = 1;  ///< of bouncing back; else specular
  double temperature = 1;  ///< of a thermal wall, > 0
};

/// Whether the rule draws random numbers.
inline bool draws(const WallRule& rule) {
  return rule.kind == WallKind::thermal || rule.kind == WallKind::random_tangential_sign ||
         (rule.kind == WallKind::bounce_back && rule.probability < 1);
}

/// The particle that the wall acts on.
template <int D>
struct ParticleAtWall {
  Vector<D>& velocity;
  Spin<D>* spin;  ///< null: it has none
  double mass, radius, inertia;
};

/// Kinetic energy in the frame of the wall, that of the spin included.
template <int D>
double energy_beside(const Vector<D>& wall_velocity, const ParticleAtWall<D>& particle) {
  const double turning = particle.spin != nullptr ? particle.inertia * particle.spin->squaredNorm() : 0;
  return (particle.mass * (particle.velocity - wall_velocity).squaredNorm() + turning) / 2;
}

/// Collision with a wall: `normal` is the unit vector into the gas. A particle that recedes is left alone. Afterwards the
/// normal velocity relative to the wall is positive; zero only with restitution 0.
template <int D>
void reflect(const WallRule& rule, const Vector<D>& normal, const Vector<D>& wall_velocity,
             const ParticleAtWall<D>& particle, Random& random);

}  // namespace sandglass
