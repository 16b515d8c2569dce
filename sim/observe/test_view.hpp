#pragma once

#include "sim/base/random.hpp"
#include "sim/observe/view.hpp"

#include <vector>

namespace sandglass {

/// A tiny system for tests of observers: cells given as lists of particles.
template <int D>
struct TestSystem {
  std::vector<Phase<D>> particles;
  std::vector<std::uint32_t> offsets{0};
  std::vector<Spin<D>> spins;
  std::vector<std::uint8_t> species;
  std::vector<SpeciesTraits> traits;
  SpeciesTraits plain;
  Tally tally;
  std::vector<Plane> planes;
  WallImpulses<D> walls;
  Vector<D> box = Vector<D>::Constant(4);
  std::vector<double> weights;
  double mass = 2, weight = 3, time = 0;  ///< the mass is that of particles without traits

  void add_cell(const std::vector<Phase<D>>& members) {
    particles.insert(particles.end(), members.begin(), members.end());
    offsets.push_back(static_cast<std::uint32_t>(particles.size()));
  }
  View<D> view() {
    View<D> view;
    view.particles = particles;
    view.offsets = offsets;
    view.columns.add(column::spin<D>, spins);
    view.columns.add(column::species, species);
    view.columns.add(column::weight, weights);
    plain.mass = mass;
    view.traits = traits.empty() ? std::span<const SpeciesTraits>(&plain, 1) : traits;
    view.box = box;
    view.weight = weight;
    view.time = time;
    view.tally = &tally;
    view.planes = &planes;
    view.walls = &walls;
    return view;
  }
};

/// Independent particles, uniform over the box, with velocities uniform in a cube around (1, 0, ...); seven a cell.
template <int D>
TestSystem<D> random_system(const Vector<D>& box, std::size_t count, std::uint64_t seed) {
  Random random(StreamKey(seed, Purpose::positions, D, 0), 0);
  TestSystem<D> system;
  system.box = box;
  std::vector<Phase<D>> cell;
  for (std::size_t i = 1; i <= count; ++i) {
    Phase<D> particle{Vector<D>::Zero(), Vector<D>::Unit(0)};
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = box[axis] * random.uniform();
      particle.velocity[axis] += 2 * random.uniform() - 1;
    }
    cell.push_back(particle);
    if (i % 7 != 0 && i != count) continue;
    system.add_cell(cell);
    cell.clear();
  }
  return system;
}

}  // namespace sandglass
