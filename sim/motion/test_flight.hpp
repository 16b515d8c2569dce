#pragma once

#include "sim/motion/motion_stage.hpp"

#include <cmath>

namespace sandglass::motion {

template <int D>
Vector<D> box() {
  return Vector<3>(2.3, 1.7, 4.9).head<D>();
}

template <int D>
Vector<D> random_vector(Random& random) {
  Vector<D> vector;
  for (int axis = 0; axis < D; ++axis) vector[axis] = random.uniform();
  return vector;
}

template <int D>
Grid<D> five_cells() {
  std::array<std::uint32_t, D> cells;
  cells.fill(5);
  return {box<D>(), cells};
}

template <int D>
ParticleStore<D> store_of(const std::vector<Phase<D>>& particles,
                          const LatticeOfCells<D>& cells = five_cells<D>()) {
  ParticleStore<D> store(cells, {column::id});
  store.assign({particles, {}});
  return store;
}

/// Particles anywhere in the box, `speed` at most along each axis; `beyond`: displaced afterwards, as offsets do it.
template <int D>
ParticleStore<D> scattered(double speed, double beyond = 0, std::size_t count = 2000,
                           const LatticeOfCells<D>& cells = five_cells<D>()) {
  Random random(StreamKey(3, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> particles(count);
  for (Phase<D>& particle : particles)
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = box<D>()[axis] * random.uniform();
      particle.velocity[axis] = speed * (2 * random.uniform() - 1);
    }
  ParticleStore<D> store = store_of<D>(particles, cells);
  for (Phase<D>& particle : store.phases())
    for (int axis = 0; axis < D; ++axis) particle.position[axis] += beyond * (2 * random.uniform() - 1);
  return store;
}

/// One step of all particles, without the sort.
template <int D>
void advance(const MotionStage<D>& motion, ParticleStore<D>& store, const MotionStep& step) {
  store.begin_step();
  motion.advance(store, 0, store.size(), step);
}

inline StreamKey wall_key(std::uint64_t step) { return {5, Purpose::walls, 0, step}; }

template <int D>
WallPlace<D> wall(int axis, bool high, const WallRule& rule) {
  WallPlace<D> place;
  place.axis = axis;
  place.high = high;
  place.edge = high ? box<D>()[axis] : 0;
  place.rule = rule;
  return place;
}

/// A few obstacles that touch neither each other nor the edges of the box.
template <int D>
std::vector<ObstaclePlace<D>> some_obstacles(const WallRule& rule = {}) {
  const Vector<3> centres[] = {{0.5, 0.5, 0.6}, {1.3, 1.1, 1.9}, {1.9, 0.45, 3.1}, {0.6, 1.25, 4.2}};
  const double radii[] = {0.3, 0.35, 0.2, 0.25};
  std::vector<ObstaclePlace<D>> obstacles;
  for (std::size_t i = 0; i < 4; ++i) obstacles.push_back({centres[i].template head<D>(), radii[i], rule});
  return obstacles;
}

}  // namespace sandglass::motion
