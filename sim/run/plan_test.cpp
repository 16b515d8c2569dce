#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "sim/run/test_hard.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::plan_test {
namespace {

void expect_bytes_as_planned(const Scene& scene) {
  const double held = run_scene(scene).timings.at("bytes-per-particle");
  EXPECT_NEAR(plan(scene).bytes_per_particle / held, 1, 0.01)
      << scene.domain.dimension << "D, ids " << scene.output.ids << ", held " << held;
}

TEST(Plan, TellsTheBytesThatTheRunHolds) {
  for (int dimension : {2, 3})
    for (bool ids : {false, true})
      for (ContactFactor factor : {ContactFactor::none, ContactFactor::local}) {
        Scene scene = test_scene(dimension, dimension == 2 ? 300 : 40, 20'000);
        scene.run.duration.steps = 1;
        scene.output.ids = ids;
        dsmc_options(scene).contact_factor = factor;
        expect_bytes_as_planned(scene);
        dsmc_options(scene).cells.assign(static_cast<std::size_t>(dimension), dimension == 2 ? 100 : 21);
        expect_bytes_as_planned(scene);
      }
}

TEST(Plan, TellsTheBytesOfTheSamples) {
  Scene scene = test_scene(2, 300, 2000);
  scene.run.replicas = 2;
  scene.run.duration.steps = 60;
  for (const Cadence& cadence : {Cadence{Cadence::Unit::steps, 3}, Cadence{Cadence::Unit::time, 0.2},
                                 Cadence{Cadence::Unit::time, 1e-9}}) {
    scene.observe.resize(2);
    scene.observe[0].what = "energy";
    scene.observe[1].what = "fields";
    scene.observe[1].grid = {10, 20};
    for (Observe& observe : scene.observe) observe.cadence = cadence;
    double held = 0;
    for (const Replica& replica : run_scene(scene).replicas)
      for (const Series& series : replica.series)
        held += sizeof(double) * static_cast<double>(series.value.size() + 2 * series.samples());
    EXPECT_NEAR(plan(scene).bytes_of_samples / held, 1, 1e-9) << cadence.every;
  }
}

/// A wall that draws names its random streams by particle.
TEST(Plan, TellsTheIdsThatRandomWallsNeed) {
  Scene scene = hard_scene({300, 300}, 20'000);
  wall_in(scene, 0);
  scene.run.duration.steps = 1;
  scene.walls.push_back({});
  const auto held = [&] { return run_scene(scene).timings.at("bytes-per-particle"); };
  const Plan plain = plan(scene);
  const double held_plain = held();
  EXPECT_EQ(std::ranges::count(plain.columns, "id"), 0);
  scene.walls[0].surface.rule = SurfaceKind::thermal;
  scene.walls[0].surface.temperature = 1;
  const Plan random = plan(scene);
  EXPECT_EQ(std::ranges::count(random.columns, "id"), 1);
  EXPECT_EQ(std::ranges::count(random.used, "particle identities"), 1);
  EXPECT_EQ(random.bytes_per_particle, plain.bytes_per_particle + 8);
  EXPECT_NEAR(held(), held_plain + 8, 0.5);
}

TEST(Plan, TellsTheCells) {
  Scene scene = test_scene(2, 30, 900);
  dsmc_options(scene).cell_size = 3.1;
  EXPECT_EQ(plan(scene).cells, 100u);
  EXPECT_DOUBLE_EQ(plan(scene).particles_per_cell, 9);
  dsmc_options(scene).cells = {4, 5};
  EXPECT_EQ(plan(scene).cells, 20u);
}

/// Mean free path of disks 1/(2 sqrt(2) n d), of spheres 1/(sqrt(2) pi n d^2).
TEST(Plan, TellsTheMeanFreePath) {
  Scene disks = test_scene(2, 30, 90);
  dsmc_options(disks).cells = {10, 10};
  EXPECT_NEAR(plan(disks).cell_size_in_mean_free_paths, 3 * 2 * M_SQRT2 * 0.1, 1e-12);
  Scene spheres = test_scene(3, 30, 2700);
  dsmc_options(spheres).cells = {10, 10, 10};
  EXPECT_NEAR(plan(spheres).cell_size_in_mean_free_paths, 3 * M_SQRT2 * M_PI * 0.1, 1e-12);
}

TEST(Plan, WarnsOfCoarseCellsAndLongSteps) {
  Scene scene = test_scene(2, 30, 900);
  dsmc_options(scene).cells = {20, 20};
  EXPECT_EQ(plan(scene).warnings.size(), 2u);  // wider than a mean free path; fewer than five particles
  scene.method.time_step.fixed = 10;
  EXPECT_EQ(plan(scene).warnings.size(), 3u);
}

/// "Lower the cell size" beside "widen the cells" would be no advice.
TEST(Plan, DoesNotAdviseWiderAndNarrowerCellsAtOnce) {
  const auto says = [](const Plan& plan, const std::string& words) {
    return std::ranges::any_of(
        plan.warnings, [&](const std::string& text) { return text.find(words) != std::string::npos; });
  };
  Scene dense = test_scene(2, 30, 900);
  dsmc_options(dense).cells = {20, 20};
  EXPECT_TRUE(says(plan(dense), "lower 'method.cell-size'"));
  EXPECT_FALSE(says(plan(dense), "widen"));
  EXPECT_TRUE(says(plan(dense), "again; lower 'method.weight'"));
  Scene thin = test_scene(2, 300, 900);
  dsmc_options(thin).cells = {300, 300};
  EXPECT_FALSE(says(plan(thin), "lower 'method.cell-size'"));
  EXPECT_TRUE(says(plan(thin), "widen the cells or lower 'method.weight'"));
}

/// Cells that keep others out are a length of the model: one warning says so, and none asks for other cells.
TEST(Plan, AdvisesNoCellsWhereTheyHoldTheExcludedVolume) {
  Scene scene = test_scene(2, 30, 900);
  dsmc_options(scene).cells = {20, 20};
  dsmc_options(scene).excluded_volume = ExcludedVolume::cells;
  const Plan crowded = plan(scene);
  ASSERT_EQ(crowded.warnings.size(), 1u);
  EXPECT_NE(crowded.warnings[0].find("compare two values of 'method.cell-size'"), std::string::npos);
  for (const char* advice : {"widen", "lower", "a cell,"})
    EXPECT_EQ(crowded.warnings[0].find(advice), std::string::npos) << crowded.warnings[0];
  scene.method.time_step.fixed = 10;
  EXPECT_EQ(plan(scene).warnings.size(), 2u);
  Scene thin = test_scene(2, 300, 900);
  dsmc_options(thin).cells = {10, 10};
  dsmc_options(thin).excluded_volume = ExcludedVolume::cells;
  EXPECT_TRUE(plan(thin).warnings.empty());
}

/// Enough for a hundred particles, whatever the scene says nothing about; the record names what the plan says.
TEST(Plan, TellsTheWindowOfTheContactFactor) {
  Scene scene = test_scene(2, 30, 900);
  dsmc_options(scene).cells = {15, 15};
  EXPECT_EQ(plan(scene).density_window, 0U);
  dsmc_options(scene).contact_factor = ContactFactor::local;
  EXPECT_EQ(plan(scene).density_window, 5U);  // 25 cells of 4
  const Record chosen = run_scene(scene);
  EXPECT_NE(chosen.scene.find("density-window = 5\n"), std::string::npos) << chosen.scene;
  const Record again = run_scene(read_scene_text(chosen.scene, "recorded"));
  EXPECT_EQ(again.replicas[0].counters, chosen.replicas[0].counters);
  dsmc_options(scene).density_window = 3;
  EXPECT_EQ(plan(scene).density_window, 3U);
  EXPECT_NE(run_scene(scene).replicas[0].counters, chosen.replicas[0].counters);
  dsmc_options(scene).density_window.reset();
  dsmc_options(scene).density = DensityEstimate::cell;
  EXPECT_EQ(plan(scene).density_window, 0U);
}

/// Where gravity packs particles the mean density of the box is not the one that they see.
TEST(Plan, WarnsOfAWindowThatIsWideForWhatGravityPacks) {
  Scene scene = test_scene(2, 30, 90);
  dsmc_options(scene).cells = {10, 10};
  dsmc_options(scene).contact_factor = ContactFactor::local;
  const auto says = [&] {
    return std::ranges::any_of(plan(scene).warnings, [](const std::string& text) {
      return text.find("'method.density-window'") != std::string::npos;
    });
  };
  EXPECT_FALSE(says());
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.gravity = {0, -1};
  EXPECT_TRUE(says());
  dsmc_options(scene).density_window = 5;
  EXPECT_FALSE(says());
}

/// A source fills an empty box: 0/0 is no plan.
TEST(Plan, OfCollisionsWithoutAParticleIsUnknown) {
  Scene scene = test_scene(2, 30, 0);
  dsmc_options(scene).cells = {10, 10};
  scene.sources.resize(1);
  scene.sources[0].rate = 1;
  scene.sources[0].centre = {15, 15};
  scene.run.duration = {{}, {}, 20.0};
  const Plan planned = plan(scene);
  for (double work : {planned.steps, planned.particle_moves, planned.expected_collisions})
    EXPECT_EQ(work, HUGE_VAL);
}

TEST(Run, RefusesToWaitForCollisionsThatNeverCome) {
  Scene scene = test_scene(2, 10, 2);
  scene.initial.temperature = 1e-300;
  scene.run.duration = {{}, {}, 1.0};
  try {
    run_scene(scene);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("no collision in 1000000 steps"), std::string::npos)
        << error.what();
  }
}

/// Over open sides the last pair may leave before it has collided so often.
TEST(Run, RefusesToWaitForCollisionsOfParticlesThatHaveLeft) {
  Scene scene = test_scene(2, 10, 50);
  scene.domain.sides.assign(2, {Side::open, Side::open});
  scene.run.duration = {{}, {}, 1000.0};
  try {
    run_scene(scene);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("of the particles left"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sandglass::plan_test
