#include "sim/record/record.hpp"
#include "sim/run/initial.hpp"
#include "sim/run/run.hpp"
#include "sim/run/setup.hpp"
#include "sim/run/test_same.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::mixing_test {
namespace {

Scene fluids() {
  return read_scene_text(R"(
[run]
duration = { steps = 120 }
[domain]
dimension = 2
size = [100.0, 100.0]
sides = { x = "specular", y = "specular" }
[[species]]
name = "heavy"
count = 16
diameter = 10.0
mass = 4.0
[[species]]
name = "light"
count = 48
diameter = 10.0
[method]
preset = "mixing"
time-step = 1e-3
softening-length = 0.1
core-exponent = 3
cutoff = 20.0
support-blocks = [8, 8]
wall-speed-factor = 0.9
[forces]
gravity = [0.0, -980.0]
[initial]
positions = "layers"
uniform-velocity = 500.0
[[observe]]
what = "two-fluids"
grid = [2, 2]
every = { steps = 7 }
[[observe]]
what = "energy"
every = { steps = 10 }
[output]
ids = true
trajectory = { steps = 20 }
)",
                         "fluids.toml");
}

TEST(RunMixing, PlacesTheFirstSpeciesOnTop) {
  const auto setup = set_up<2>(fluids(), {});
  const Particles<2> particles = initial_particles(setup, {});
  const auto species = particles.columns.get(column::species);
  ASSERT_EQ(particles.phases.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) {
    const Phase<2>& particle = particles.phases[i];
    EXPECT_EQ(species[i], particle.position[1] > 75 ? 0 : 1);
    EXPECT_LE(particle.velocity.cwiseAbs().maxCoeff(), 500);
  }
  EXPECT_NEAR(particles.phases.front().position[1], 93.75, 1e-12);
  EXPECT_NEAR(particles.phases.front().position[0], 6.25, 1e-12);
}

TEST(RunMixing, ResumesBitwise) {
  Scene scene = fluids();
  const Record whole = run_scene(scene);
  scene.output.checkpoint = Cadence{Cadence::Unit::steps, 50};
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + "run_mixing.checkpoint.h5";
  expect_same(run_scene(scene, options), whole);
  const Record checkpoint = read_record(options.checkpoint_path);
  EXPECT_EQ(checkpoint.state->step, 100u);
  expect_same(resume(checkpoint), whole);
}

TEST(RunMixing, EveryPlantedFaultChangesTheRun) {
  const Record honest = run_scene(fluids());
  for (const PlantedFault& fault : planted_faults("mixing")) {
    RunOptions options;
    options.planted_fault = fault.name;
    EXPECT_NE(run_scene(fluids(), options).replicas[0].series.back().value,
              honest.replicas[0].series.back().value)
        << fault.name;
  }
}

TEST(RunMixing, FluidsAtRestAndOneBlockWideStayBounded) {
  Scene scene = fluids();
  scene.initial.uniform_velocity = 0;
  std::get<MixingOptions>(scene.method.options).support_blocks = {1, 2};
  const Record record = run_scene(scene);
  for (const Frame& frame : record.trajectory)
    for (const double x : frame.position) EXPECT_TRUE(x >= 0 && x <= 100) << x;
}

TEST(RunMixing, PlanWarnsOfStepsBeyondStability) {
  Scene scene = fluids();
  scene.initial.uniform_velocity = 1;
  EXPECT_TRUE(plan(scene).warnings.empty());
  scene.initial.uniform_velocity = 500;
  ASSERT_EQ(plan(scene).warnings.size(), 1u);
  EXPECT_NE(plan(scene).warnings.front().find("method.time-step"), std::string::npos);
}

/// Within the printed digits, and another in each replica.
TEST(RunMixing, RoundingChangesVelocitiesWithinItsBound) {
  Scene scene = fluids();
  scene.species[0].count = scene.species[1].count = {};
  scene.initial = {};
  scene.initial.velocity_rounding = 0.005;
  scene.given = {{{20, 20}, {1, 2}, {}, 0}, {{60, 70}, {-3, 4}, {}, 1}};
  const auto setup = set_up<2>(scene, {});
  const Particles<2> one = initial_particles(setup, {1, 0}), two = initial_particles(setup, {1, 1});
  for (std::size_t i = 0; i < 2; ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const double off =
          one.phases[i].velocity[axis] - scene.given[i].velocity[static_cast<std::size_t>(axis)];
      EXPECT_TRUE(off != 0 && std::abs(off) <= 0.005);
      EXPECT_NE(one.phases[i].velocity[axis], two.phases[i].velocity[axis]);
    }
}

}  // namespace
}  // namespace sandglass::mixing_test
