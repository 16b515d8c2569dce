#pragma once

#include "sim/method/simulator.hpp"
#include "sim/run/test_scene.hpp"
#include "sim/scene/observe/observers.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace sandglass {

/// Hard disks or spheres of diameter 1 in a periodic box, to be changed by a test.
inline Scene hard_scene(const std::vector<double>& box, std::uint64_t count,
                        Positions positions = Positions::lattice) {
  Scene scene = test_scene(static_cast<int>(box.size()), 1, count);
  scene.domain.size = box;
  choose(scene.method, "event-driven");
  scene.initial.positions = positions;
  return scene;
}

inline void wall_in(Scene& scene, std::size_t axis) {
  scene.domain.sides[axis] = {Side::specular, Side::specular};
}

/// The narrowest gap between any two surfaces, by trying every pair, wall and obstacle; below 0: an overlap.
template <int D>
double narrowest_gap(const Scene& scene, const std::vector<Phase<D>>& particles,
                     std::span<const std::uint8_t> species = {}) {
  const auto radius = [&](std::size_t i) {
    return scene.species[species.empty() ? 0 : species[i]].diameter / 2;
  };
  double gap = HUGE_VAL;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vector<D>& here = particles[i].position;
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const bool wall = scene.domain.sides[a][0] == Side::specular;
      gap = std::min({gap, here[axis] - (wall ? radius(i) : 0),
                      scene.domain.size[a] - here[axis] - (wall ? radius(i) : 0)});
    }
    for (const Obstacle& obstacle : scene.obstacles)
      gap = std::min(gap, (here - Eigen::Map<const Vector<D>>(obstacle.centre.data())).norm() -
                              obstacle.radius - radius(i));
    for (std::size_t j = 0; j < i; ++j) {
      Vector<D> apart = here - particles[j].position;
      for (int axis = 0; axis < D; ++axis)
        if (scene.domain.sides[static_cast<std::size_t>(axis)][0] == Side::periodic)
          apart[axis] = std::remainder(apart[axis], scene.domain.size[static_cast<std::size_t>(axis)]);
      gap = std::min(gap, apart.norm() - radius(i) - radius(j));
    }
  }
  return gap;
}

}  // namespace sandglass
