#include "sim/method/boundary_faults.hpp"

#include <gtest/gtest.h>

// Each planted fault changes what it says and nothing else.

namespace sandglass::boundary_faults_test {
namespace {

Scene driven_scene() {
  Scene scene;
  scene.domain = {2, {10, 20}, {{Side::open, Side::specular}, {Side::specular, Side::open}}};
  scene.gravity = {0, -1};
  scene.method.time_step = {{}, {}, 0.3};
  scene.walls.resize(2);
  scene.walls[0].high = true;
  scene.walls[0].surface = {SurfaceKind::bounce_back, 0.5};
  scene.walls[0].velocity = {0.5, 0};
  scene.walls[1].axis = 1;
  scene.walls[1].surface.rule = SurfaceKind::thermal;
  scene.walls[0].surface.probability = 0.25;
  scene.walls[1].surface.temperature = 2;
  scene.obstacles = {{{5, 5}, 1, {SurfaceKind::specular, 0.9}}};
  scene.inflows.resize(2);
  scene.inflows[0].velocity = {2, 0};
  scene.sources = {{2, 100, {}, {3, 3}, {}, {}}, {0.5, {}, {}, {6, 3}, {}, {}}};
  return scene;
}

using Change = void (*)(Scene&);

void expect_only(const std::string& fault, Change change) {
  Scene expected = driven_scene();
  change(expected);
  EXPECT_NE(expected, driven_scene());
  EXPECT_EQ(with_scene_fault(driven_scene(), fault), expected) << fault;
}

TEST(BoundaryFaults, ChangeWhatTheySay) {
  expect_only("gravity-reversed", [](Scene& scene) { scene.gravity = {-0.0, 1}; });
  expect_only("gravity-plus-1-percent", [](Scene& scene) { scene.gravity = {0, -1.01}; });
  expect_only("wall-restitution-plus-2-percent", [](Scene& scene) {
    scene.walls[0].surface.restitution = 1.02 * 0.5;
    scene.obstacles[0].surface.restitution = 1.02 * 0.9;
  });
  expect_only("wall-restitution-dropped", [](Scene& scene) {
    scene.walls[0].surface.restitution = scene.obstacles[0].surface.restitution = 1;
  });
  expect_only("thermal-surfaces-draw-maxwellian",
              [](Scene& scene) { scene.walls[1].surface.probability = 0; });
  expect_only("thermal-surfaces-reflect", [](Scene& scene) { scene.walls[1].surface = {}; });
  expect_only("wall-temperature-plus-10-percent",
              [](Scene& scene) { scene.walls[1].surface.temperature = 1.1 * 2; });
  expect_only("high-walls-lossless", [](Scene& scene) { scene.walls[0].surface.restitution = 1; });
  expect_only("cell-fraction-times-5", [](Scene& scene) { scene.method.time_step.cell_fraction = 1.5; });
  expect_only("wall-temperature-plus-20-percent",
              [](Scene& scene) { scene.walls[1].surface.temperature = 1.2 * 2; });
  expect_only("bounce-back-probability-ignored",
              [](Scene& scene) { scene.walls[0].surface.probability = 1; });
  expect_only("wall-velocity-dropped", [](Scene& scene) { scene.walls[0].velocity.clear(); });
  expect_only("obstacle-radius-plus-2-percent", [](Scene& scene) { scene.obstacles[0].radius = 1.02; });
  expect_only("open-sides-reflect", [](Scene& scene) {
    scene.domain.sides = {{Side::specular, Side::specular}, {Side::specular, Side::specular}};
  });
  expect_only("inflows-draw-maxwellian", [](Scene& scene) {
    scene.inflows[0].fault = scene.inflows[1].fault = InflowFault::maxwellian;
  });
  expect_only("inflow-drift-dropped", [](Scene& scene) { scene.inflows[0].velocity.clear(); });
  expect_only("inflow-remainder-dropped", [](Scene& scene) {
    scene.inflows[0].fault = scene.inflows[1].fault = InflowFault::remainder_dropped;
  });
  expect_only("inflow-off-by-one", [](Scene& scene) {
    scene.inflows[0].fault = scene.inflows[1].fault = InflowFault::off_by_one;
  });
  expect_only("source-rate-minus-10-percent", [](Scene& scene) {
    scene.sources[0].rate = 0.9 * 2;
    scene.sources[1].rate = 0.9 * 0.5;
  });
}

TEST(BoundaryFaults, NoneChangesNothing) {
  EXPECT_EQ(with_scene_fault(driven_scene(), ""), driven_scene());
  EXPECT_EQ(boundary_faults().size() + exchange_faults().size() + step_faults().size(), 20u);
}

/// Each mirror gets a table, whether the scene has one or not; the open and the thermal side stay as they are.
TEST(BoundaryFaults, LossOfMirrorsReachesThoseWithoutATable) {
  Scene scene;
  scene.domain = {2, {10, 20}, {{Side::periodic, Side::periodic}, {Side::specular, Side::specular}}};
  scene.walls.resize(1);
  scene.walls[0].axis = 1;
  Scene expected = scene;
  expected.walls.resize(2);
  expected.walls[1].axis = 1;
  expected.walls[1].high = true;
  for (Wall& wall : expected.walls) wall.surface.restitution = 0.98;
  EXPECT_EQ(with_scene_fault(scene, "mirrors-lose-2-percent"), expected);
  scene.walls[0].surface.rule = expected.walls[0].surface.rule = SurfaceKind::thermal;
  expected.walls[0].surface.restitution = 1;
  EXPECT_EQ(with_scene_fault(scene, "mirrors-lose-2-percent"), expected);
}

}  // namespace
}  // namespace sandglass::boundary_faults_test
