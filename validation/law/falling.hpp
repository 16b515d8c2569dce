#pragma once

#include "validation/law/gas.hpp"

/// Particles under gravity in a box. Collisions among them do not move their centre of mass, so what it does follows
/// from what floor and walls do, whatever the method.
namespace sandglass::law {

/// Particles between side walls; momentum and heights count upwards.
struct FallingParticles {
  double count = 1;
  double mass = 1;  ///< of one
  double gravity = 1;
  double height = 0;    ///< of the centre of mass at time zero
  double velocity = 0;  ///< of the centre of mass at time zero
};

/// Centre of mass before the first particle hits the floor, or along a periodic axis before walls act:
/// h + v t - g t^2/2 [length] and v - g t [length/time]. Exact.
double falling_height(const FallingParticles& particles, double time);
double falling_velocity(const FallingParticles& particles, double time);

/// Time at which a particle at `height` above the place where it hits the floor arrives there [time]; with the lowest
/// one, and all velocities alike, the end of the free fall.
double fall_time(double height, double velocity, double gravity);

/// Time integral of the upward force of the floor, when the centre of mass moves with `velocity` at the end: N m (g t +
/// v_end - v_0) [mass length/time]. Exact; side walls without friction.
double floor_impulse(const FallingParticles& particles, double time, double end_velocity);

/// Energy lost on the way to rest with the centre of mass at `end_height`, per particle of mass m: m g (h - h_end) plus
/// the initial kinetic energy per particle [mass length^2 time^-2]. Exact; walls at rest.
double collapse_loss(const FallingParticles& particles, double end_height, double kinetic_energy);

/// Centre of mass of a packing of given fraction with a level surface on a floor of width, or area, `floor`, above the
/// lowest points of the particles: half its height N v/(fraction floor) [length]. Diameter and dimension from `gas`;
/// an error of about a diameter by the layers at floor and surface.
double packed_height(const Gas& gas, double count, double floor);

/// Friction that walls must give in steady flow along gravity, summed over them: N m g [mass length time^-2]. Exact for
/// the mean over a time in which the momentum does not change.
double steady_wall_friction(const FallingParticles& particles);

}  // namespace sandglass::law
