#include "validation/law/falling.hpp"

#include <cmath>

namespace sandglass::law {

double falling_height(const FallingParticles& particles, double time) {
  return particles.height + time * (particles.velocity - particles.gravity * time / 2);
}

double falling_velocity(const FallingParticles& particles, double time) {
  return particles.velocity - particles.gravity * time;
}

double fall_time(double height, double velocity, double gravity) {
  const double impact = std::sqrt(velocity * velocity + 2 * gravity * height);
  return velocity < 0 ? 2 * height / (impact - velocity) : (velocity + impact) / gravity;
}

double floor_impulse(const FallingParticles& particles, double time, double end_velocity) {
  return particles.count * particles.mass * (particles.gravity * time + end_velocity - particles.velocity);
}

double collapse_loss(const FallingParticles& particles, double end_height, double kinetic_energy) {
  return particles.mass * particles.gravity * (particles.height - end_height) + kinetic_energy;
}

double packed_height(const Gas& gas, double count, double floor) {
  return count * particle_volume(gas) / (gas.fraction * floor) / 2;
}

double steady_wall_friction(const FallingParticles& particles) {
  return particles.count * particles.mass * particles.gravity;
}

}  // namespace sandglass::law
