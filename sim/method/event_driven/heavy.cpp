#include "sim/method/event_driven/heavy.hpp"

#include "sim/physics/wall.hpp"

namespace sandglass::event_driven {

template <int D>
Impact<D> collide_with_heavy(const Parameters<D>& parameters, const CollisionRule<D>& rule, Gas<D>& gas,
                             std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double now,
                             std::uint64_t& guarded) {
  const HeavyParticles<D>& heavy = *parameters.heavy;
  const bool both = gas.kind(first) == kHeavy && gas.kind(second) == kHeavy;
  if (both) {  // only rounding brings them together
    gas.particles[first].velocity = gas.particles[second].velocity = heavy.velocity;
    return {Vector<D>::Zero(), 0};
  }
  const bool is_first = gas.kind(second) == kHeavy;
  const std::uint32_t light = is_first ? first : second, other = is_first ? second : first;
  const SpeciesTraits& traits = parameters.species[gas.kind(light)];
  WallRule wall;
  wall.surface = parameters.surface(gas.kind(light), kHeavy);
  if (rule.is_guarded(gas, first, second, now, guarded)) wall.surface.normal = {1, 0};
  Vector<D>& velocity = gas.particles[light].velocity;
  const ParticleAtWall<D> particle{velocity, parameters.rough ? &gas.spins[light] : nullptr, traits.mass,
                                   traits.diameter / 2, traits.inertia};
  const Vector<D> before = velocity, outward = is_first ? normal : Vector<D>(-normal);
  const double energy = energy_beside(heavy.velocity, particle);
  Random none;  // a mirror draws nothing
  reflect<D>(wall, outward, heavy.velocity, particle, none);
  gas.particles[other].velocity = heavy.velocity;
  const Vector<D> impulse = traits.mass * (velocity - before);
  if (parameters.impulses != nullptr)
    parameters.impulses->add(heavy.side, -impulse, heavy.velocity,
                             energy - energy_beside(heavy.velocity, particle));
  return {is_first ? impulse : Vector<D>(-impulse), (heavy.velocity - before).dot(outward)};
}

template Impact<2> collide_with_heavy(const Parameters<2>&, const CollisionRule<2>&, Gas<2>&, std::uint32_t,
                                      std::uint32_t, const Vector<2>&, double, std::uint64_t&);

}  // namespace sandglass::event_driven
