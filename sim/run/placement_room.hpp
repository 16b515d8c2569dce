#pragma once

#include "sim/base/vector.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace sandglass {

/// Where the centre of a particle may stand. Hard particles keep a radius away from walls and obstacles; the particles of
/// the other methods meet walls with their centre.
template <int D>
struct Room {
  Vector<D> box;
  std::array<bool, D> periodic;
  bool hard;
  std::span<const Obstacle> obstacles;

  explicit Room(const Scene& scene)
      : box(Eigen::Map<const Vector<D>>(scene.domain.size.data())),
        hard(capabilities(scene).contacts),
        obstacles(scene.obstacles) {
    for (std::size_t axis = 0; axis < D; ++axis)
      periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  }

  /// Distance that a centre keeps from both ends of an axis.
  double margin(int axis, double radius) const {
    return hard && !periodic[static_cast<std::size_t>(axis)] ? radius : 0;
  }
  /// An obstacle stands too far from every edge to be met through a periodic one.
  bool blocked(const Vector<D>& point, double radius) const {
    return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) {
      const Vector<D> away = point - Eigen::Map<const Vector<D>>(obstacle.centre.data());
      return away.norm() < obstacle.radius + radius;
    });
  }
};

}  // namespace sandglass
