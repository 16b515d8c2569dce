#include "sim/method/motion_from_scene.hpp"

#include <gtest/gtest.h>

namespace sandglass::motion_from_scene_test {
namespace {

/// In a box that is higher than wide, with sides that differ.
TEST(MotionFromScene, TakesEverySideMassAndGravityFromItsPlace) {
  Scene scene;
  scene.domain = {2, {10, 20}, {{Side::specular, Side::open}, {Side::specular, Side::specular}}};
  scene.species.emplace_back().mass = 3;
  scene.gravity = {0.5, -1};
  scene.walls.resize(2);
  scene.walls[0].axis = scene.walls[1].axis = 1;
  scene.walls[0].high = true;
  scene.walls[0].surface = {SurfaceKind::thermal};
  scene.walls[0].surface.temperature = 2;
  scene.walls[1].velocity = {0.25, 0};
  scene.walls[1].amplitude = 0.1;
  scene.walls[1].frequency = 7;
  scene.obstacles = {{{5, 6}, 1.5, {SurfaceKind::specular, 0.9}}};
  const motion::MotionParameters<2> motion = motion_of<2>(scene);
  EXPECT_EQ(motion.mass, 3);
  EXPECT_EQ(motion.gravity, Vector<2>(0.5, -1));
  EXPECT_EQ(motion.walled, (std::array{true, true}));
  EXPECT_EQ(motion.open[0], (std::array{false, true}));
  EXPECT_EQ(motion.open[1], (std::array{false, false}));
  ASSERT_EQ(motion.walls.size(), 2u);
  EXPECT_EQ(motion.walls[0].axis, 1);
  EXPECT_TRUE(motion.walls[0].high);
  EXPECT_EQ(motion.walls[0].edge, 20);
  EXPECT_EQ(motion.walls[0].rule.kind, WallKind::thermal);
  EXPECT_EQ(motion.walls[0].rule.temperature, 2);
  EXPECT_EQ(motion.walls[1].edge, 0);
  EXPECT_EQ(motion.walls[1].velocity, Vector<2>(0.25, 0));
  EXPECT_EQ(motion.walls[1].amplitude, 0.1);
  EXPECT_EQ(motion.walls[1].frequency, 7);
  ASSERT_EQ(motion.obstacles.size(), 1u);
  EXPECT_EQ(motion.obstacles[0].centre, Vector<2>(5, 6));
  EXPECT_EQ(motion.obstacles[0].radius, 1.5);
  EXPECT_EQ(motion.obstacles[0].rule.surface.normal.value, 0.9);
}

}  // namespace
}  // namespace sandglass::motion_from_scene_test
