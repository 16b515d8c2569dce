#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

// Hard particles have no scale of velocity: with walls twice as fast, a start four times as hot and half the time step,
// the same random numbers give the same motion in half the time, and forces four times as large. Exactly, since two is
// exact in floating point.

namespace sandglass::velocity_scale_test {
namespace {

/// A gas between two rough walls that move in opposite directions (Mueller 2001, section 3.3).
Scene shear_cell(const std::string& method, double speed) {
  const std::string text = R"(
[run]
duration = {{ steps = 200 }}
[domain]
dimension = 2
size = [40.0, 60.0]
sides = {{ y = "specular" }}
[[wall]]
side = "y-low"
rule = "bounce-back"
restitution = 0.97
velocity = [{}, 0.0]
[[wall]]
side = "y-high"
rule = "bounce-back"
restitution = 0.97
velocity = [{}, 0.0]
[[species]]
count = 300
restitution = 0.9
[method]
{}
time-step = {}
[initial]
positions = "lattice"
temperature = {}
[[observe]]
what = "wall-force"
every = {{ steps = 20 }}
)";
  return read_scene_text(
      fmt::format(fmt::runtime(text), -speed / 2, speed / 2, method, 0.25 / speed, 0.0625 * speed * speed),
      "shear.toml");
}

const Series& force(const Record& record) {
  for (const Series& series : record.replicas[0].series)
    if (series.quantity.name == "wall-force") return series;
  throw InputError("no series wall-force");
}

class VelocityScale : public testing::TestWithParam<const char*> {};

TEST_P(VelocityScale, TwiceTheSpeedGivesFourTimesTheForce) {
  const Record slow = run_scene(shear_cell(GetParam(), 1)), fast = run_scene(shear_cell(GetParam(), 2));
  const Series &once = force(slow), &twice = force(fast);
  ASSERT_EQ(once.value.size(), twice.value.size());
  ASSERT_GT(slow.replicas[0].counters.at("collisions"), 500);
  EXPECT_EQ(slow.replicas[0].counters.at("collisions"), fast.replicas[0].counters.at("collisions"));
  for (std::size_t i = 0; i < once.value.size(); ++i)
    EXPECT_DOUBLE_EQ(4 * once.value[i], twice.value[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(Methods, VelocityScale,
                         testing::Values("preset = \"dsmc\"\ncells = [8, 12]",
                                         "preset = \"cba\"\ncells = [8, 12]",
                                         "preset = \"hsmc\"\ncells = [20, 30]", "preset = \"event-driven\""));

/// A contact time is a scale of its own: the law does not hold, and the test would see it.
TEST(VelocityScale, AGuardBreaksIt) {
  const std::string guarded =
      "preset = \"event-driven\"\ncollapse-guard = \"contact-time\"\ncontact-time = 0.3";
  const Record slow = run_scene(shear_cell(guarded, 1)), fast = run_scene(shear_cell(guarded, 2));
  EXPECT_NE(4 * force(slow).value.back(), force(fast).value.back());
}

}  // namespace
}  // namespace sandglass::velocity_scale_test
