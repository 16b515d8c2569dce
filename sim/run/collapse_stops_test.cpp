#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "sim/scene/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// A run that collapses says so, with time and place; a guard carries it on. Times by hand.

namespace sandglass::collapse_stops_test {
namespace {

/// Falls from 1/2 with g = 1 onto a floor of restitution 0.6: first bounce at 1, and infinitely many at 1 + 2 0.6/0.4.
Scene bouncing_ball(double duration) {
  Scene scene = read_scene_text(R"(
[run]
duration = { time = 1.0 }
[domain]
dimension = 2
size = [8.0, 4.0]
sides.y = "specular"
[[wall]]
side = "y-low"
restitution = 0.6
[[species]]
[method]
preset = "event-driven"
time-step = 0.5
[forces]
gravity = [0.0, -1.0]
[initial]
positions = "given"
[[particle]]
position = [4.0, 1.0]
velocity = [0.0, 0.0]
[[observe]]
what = "energy"
)",
                                "ball.toml");
  scene.run.duration = {duration, {}, {}};
  return scene;
}

/// Three disks in a row with restitution 0.05, below 7 - 4 sqrt(3): they collapse at t = 0.414286 (a separate program
/// that adds flight to flight).
Scene row(double restitution) {
  return read_scene_text(R"(
[run]
duration = { time = 1.0 }
[domain]
dimension = 2
size = [20.0, 20.0]
[[species]]
restitution = )" + std::to_string(restitution) +
                             R"(
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "given"
[[particle]]
position = [9.0, 10.0]
velocity = [1.0, 0.0]
[[particle]]
position = [10.2, 10.0]
velocity = [0.0, 0.0]
[[particle]]
position = [11.7, 10.0]
velocity = [-1.0, 0.0]
[[observe]]
what = "energy"
)",
                         "row.toml");
}

std::string breaks(const Scene& scene) {
  try {
    run_scene(scene);
  } catch (const RunError& error) {
    return error.what();
  }
  return "it went on";
}

TEST(Collapse, OfABallOnTheFloorStopsTheRun) {
  EXPECT_EQ(breaks(bouncing_ball(3.9)), "it went on");
  const std::string message = breaks(bouncing_ball(4.5));
  EXPECT_THAT(message, testing::HasSubstr("inelastic collapse at time 4"));
  EXPECT_THAT(message, testing::HasSubstr("a wall"));
  EXPECT_THAT(message, testing::HasSubstr("collapse-guard"));
}

TEST(Collapse, VelocityDependentRestitutionCarriesTheBallOn) {
  Scene scene = bouncing_ball(8);
  scene.method.options = EventDrivenOptions{{CollapseGuard::velocity_dependent, 0, 0.5}};
  EXPECT_EQ(breaks(scene), "it went on");
}

TEST(Collapse, OfThreeInARowStopsTheRunBelowTheCriticalRestitution) {
  EXPECT_EQ(breaks(row(0.08)), "it went on");
  EXPECT_THAT(breaks(row(0.05)), testing::HasSubstr("inelastic collapse at time 0.41428"));
}

TEST(Collapse, ContactTimeCarriesTheRowOn) {
  Scene scene = row(0.05);
  scene.method.options = EventDrivenOptions{{CollapseGuard::contact_time, 1e-3, 0}};
  EXPECT_EQ(breaks(scene), "it went on");
}

}  // namespace
}  // namespace sandglass::collapse_stops_test
