#pragma once

#include "sim/base/random.hpp"
#include "sim/space/particles.hpp"

#include <vector>

namespace sandglass {

/// Particles at random places of a cube from the origin, with nearly normal velocities of variance one.
template <int D>
std::vector<Phase<D>> scattered(std::size_t count, double edge) {
  std::vector<Phase<D>> particles(count);
  const StreamKey key(1, Purpose::positions, 0, 0);
  for (std::size_t i = 0; i < count; ++i) {
    Random random(key, i);
    for (int axis = 0; axis < D; ++axis) {
      particles[i].position[axis] = edge * random.uniform();
      double normal = -6;
      for (int draw = 0; draw < 12; ++draw) normal += random.uniform();
      particles[i].velocity[axis] = normal;
    }
  }
  return particles;
}

}  // namespace sandglass
