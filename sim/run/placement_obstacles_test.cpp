#include "sim/run/placement.hpp"
#include "sim/run/placement_room.hpp"
#include "sim/run/test_hard.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::placement_obstacles_test {
namespace {

constexpr double kEdge = 40, kRadius = 0.5;  // of the domain, of a particle

template <int D>
Vector<D> point_in(Random& random, double margin) {
  Vector<D> point;
  for (int axis = 0; axis < D; ++axis) point[axis] = margin + (kEdge - 2 * margin) * random.uniform();
  return point;
}

/// Obstacles of every size, that overlap each other here and there.
template <int D>
Scene scene_of_obstacles(std::size_t count) {
  Scene scene = hard_scene(std::vector<double>(D, kEdge), 40, Positions::random_without_overlap);
  Random random(StreamKey(5, Purpose::positions, 0, count), D);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = std::pow(10, -2 * random.uniform()) * (i % 100 == 0 ? 4 : 1);
    const Vector<D> centre = point_in<D>(random, radius + 1);
    scene.obstacles.push_back({{centre.data(), centre.data() + D}, radius, {}});
  }
  return scene;
}

template <int D>
Vector<D> centre_of(const Obstacle& obstacle) {
  return Eigen::Map<const Vector<D>>(obstacle.centre.data());
}

/// The slow twin: every obstacle.
template <int D>
bool blocked_by_any(const Scene& scene, const Vector<D>& point, double radius) {
  return std::ranges::any_of(scene.obstacles, [&](const Obstacle& obstacle) {
    return (point - centre_of<D>(obstacle)).norm() < obstacle.radius + radius;
  });
}

/// Also points at the distance of contact, where rounding decides.
template <int D>
void expect_blocked_like_twin(std::size_t count) {
  const Scene scene = scene_of_obstacles<D>(count);
  const Room<D> room(scene);
  Random random(StreamKey(6, Purpose::positions, 0, count), D);
  std::size_t blocked = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Vector<D> point = point_in<D>(random, 0);
    const double radius = trial % 3 == 0 ? 0 : kRadius;
    if (trial % 2 == 0 && count > 0) {
      const Obstacle& obstacle = scene.obstacles[static_cast<std::size_t>(trial) % count];
      const Vector<D> away = point - centre_of<D>(obstacle);
      point = centre_of<D>(obstacle) + away * ((obstacle.radius + radius) / away.norm());
    }
    const bool expected = blocked_by_any<D>(scene, point, radius);
    ASSERT_EQ(room.blocked(point, radius), expected) << point.transpose();
    blocked += expected;
  }
  EXPECT_EQ(blocked > 0, count > 0);
}

TEST(PlacementObstacles, BlockWhatTheirTwinBlocks) {
  for (const std::size_t count : {0u, 1u, 30u, 1000u}) {
    expect_blocked_like_twin<2>(count);
    expect_blocked_like_twin<3>(count);
  }
}

/// Random sequential addition in a periodic box, with every pair tried.
template <int D>
std::vector<Vector<D>> added_one_by_one(const Scene& scene, std::size_t count) {
  std::vector<Vector<D>> points;
  const auto touches = [](const Vector<D>& a, const Vector<D>& b) {
    Vector<D> gap = a - b;
    for (int axis = 0; axis < D; ++axis) gap[axis] = std::remainder(gap[axis], kEdge);
    return gap.norm() < 2 * kRadius;
  };
  for (std::size_t i = 0; i < count; ++i) {
    Random random(StreamKey(1, Purpose::positions, 0, 0), i);
    Vector<D> point;
    do point = point_in<D>(random, 0);
    while (blocked_by_any<D>(scene, point, kRadius) ||
           std::ranges::any_of(points, [&](const Vector<D>& other) { return touches(point, other); }));
    points.push_back(point);
  }
  return points;
}

template <int D>
void expect_placed_like_twin(std::size_t obstacles) {
  const Scene scene = scene_of_obstacles<D>(obstacles);
  const std::uint64_t count = particle_count(scene);
  const auto placed = place<D>(scene, count, {1, 0});
  const auto expected = added_one_by_one<D>(scene, count);
  ASSERT_EQ(placed.size(), expected.size());
  for (std::size_t i = 0; i < placed.size(); ++i) ASSERT_EQ(placed[i].position, expected[i]) << i;
}

TEST(PlacementObstacles, LeaveTheRoomThatTheirTwinLeaves) {
  expect_placed_like_twin<2>(300);
  expect_placed_like_twin<3>(5000);
}

}  // namespace
}  // namespace sandglass::placement_obstacles_test
