#pragma once

#include "sim/base/vector.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "sim/space/ball_index.hpp"

#include <algorithm>
#include <array>

namespace sandglass {

/// Where the centre of a particle may stand. Hard particles keep a radius away from walls and obstacles; the particles of
/// the other methods meet walls with their centre.
template <int D>
struct Room {
  Vector<D> box;
  std::array<bool, D> periodic;
  bool hard;
  BallIndex<D> obstacles;

  explicit Room(const Scene& scene)
      : box(Eigen::Map<const Vector<D>>(scene.domain.size.data())),
        hard(capabilities(scene).contacts),
        obstacles(balls_of(scene)) {
    for (std::size_t axis = 0; axis < D; ++axis)
      periodic[axis] = scene.domain.sides[axis][0] == Side::periodic;
  }

  /// Distance that a centre keeps from both ends of an axis.
  double margin(int axis, double radius) const {
    return hard && !periodic[static_cast<std::size_t>(axis)] ? radius : 0;
  }
  /// An obstacle stands too far from every edge to be met through a periodic one.
  bool blocked(const Vector<D>& point, double radius) const {
    const Vector<D> reach = Vector<D>::Constant(radius + kRounding * box.maxCoeff());
    bool found = false;
    obstacles.for_each_touching(point - reach, point + reach, [&](std::uint32_t i) {
      const Ball<D>& obstacle = obstacles.balls()[i];
      found = (point - obstacle.centre).norm() < obstacle.radius + radius;
      return !found;
    });
    return found;
  }

 private:
  /// The boxes that are searched are wider by this share of the domain: rounding hides no obstacle.
  static constexpr double kRounding = 1e-12;

  static std::vector<Ball<D>> balls_of(const Scene& scene) {
    std::vector<Ball<D>> balls;
    balls.reserve(scene.obstacles.size());
    for (const Obstacle& obstacle : scene.obstacles)
      balls.push_back({Eigen::Map<const Vector<D>>(obstacle.centre.data()), obstacle.radius});
    return balls;
  }
};

}  // namespace sandglass
