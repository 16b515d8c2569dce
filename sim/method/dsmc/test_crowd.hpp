#pragma once

#include "sim/method/dsmc/cell_collisions.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace sandglass::dsmc {

/// Disks or spheres of diameter one in cells that ten of them fill, some fuller than others: for tests of full cells.
template <int D>
Parameters crowd_parameters(double restitution = 0.7) {
  Parameters parameters;
  parameters.cross_section = cross_section(D, 1);
  parameters.restitution = restitution;
  parameters.excluded_volume.densest = 0.8;
  parameters.weight = 0.08 / particle_volume(D, 1);  // a tenth of the densest in a cell of volume one
  return parameters;
}

template <int D>
Grid<D> crowd_grid(std::uint32_t cells = 6) {
  std::array<std::uint32_t, D> numbers;
  numbers.fill(cells);
  return {Vector<D>::Constant(cells), numbers};
}

/// Scattered: 9 to a cell on average, so that about 4 in 10 are full.
template <int D>
std::vector<Phase<D>> crowd(const Grid<D>& grid, double per_cell = 9, std::uint64_t index = 0) {
  Random random(StreamKey(7, Purpose::positions, 0, 0), index);
  std::vector<Phase<D>> particles(static_cast<std::size_t>(per_cell * grid.size()));
  for (Phase<D>& particle : particles)
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = grid.box()[axis] * random.uniform();
      particle.velocity[axis] = 2 * random.uniform() - 1;
    }
  return particles;
}

template <int D>
Vector<D> momentum(std::span<const Phase<D>> particles) {
  Vector<D> sum = Vector<D>::Zero();
  for (const Phase<D>& particle : particles) sum += particle.velocity;
  return sum;
}

template <int D>
double energy(std::span<const Phase<D>> particles) {
  double sum = 0;
  for (const Phase<D>& particle : particles) sum += 0.5 * particle.velocity.squaredNorm();
  return sum;
}

}  // namespace sandglass::dsmc
