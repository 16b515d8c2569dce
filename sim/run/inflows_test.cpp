#include "sim/run/inflows.hpp"

#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/run/test_run_text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::inflows_test {
namespace {

/// A stream through a box without collisions, which begins empty.
const std::string kStream = R"(
[run]
duration = { time = 40.0 }
[domain]
dimension = 2
size = [10.0, 5.0]
sides.x = "open"
[[species]]
count = 0
mass = 2.0
diameter = 0.01
restitution = 1.0
[[inflow]]
side = "x-low"
number-density = 20.0
velocity = [1.0, 0.5]
temperature = 0.5
arrivals = "even"
[method]
preset = "collisionless"
time-step = 0.07
[[observe]]
what = "fields"
grid = [10, 1]
every = { steps = 1 }
[output]
ids = true
trajectory = { steps = 100 }
)";

double counted(const Record& record, const std::string& name) { return record.replicas[0].counters.at(name); }

double inside(const Record& record) {
  const Series& fields = record.replicas[0].series[0];
  double particles = 0;
  for (std::size_t bin = 0; bin < 10; ++bin)
    particles += 5 * fields.value[fields.value.size() - 40 + 4 * bin];
  return particles;
}

/// 20 a volume, thermal speed 0.5, so U/s = 2: the flux is U F(2) + s f(2) of the normal distribution.
const double kRate = 5 * 20 * (0.9772498680518208 + 0.5 * 0.05399096651318806);

TEST(Inflows, BringInAsManyAsTheirFluxSays) {
  const Record record = run_text(kStream);
  EXPECT_EQ(counted(record, "particles-entered"), std::floor(kRate * 572 * 0.07));
  EXPECT_EQ(counted(record, "particles-entered-x-low"), counted(record, "particles-entered"));
  EXPECT_NEAR(inside(record), counted(record, "particles-entered") - counted(record, "particles-left"), 1e-6);
}

/// Steps in a row are independent, and each has the variance of its mean.
TEST(Inflows, ArriveAsPoissonSays) {
  const std::string text = edited(edited(kStream, "\"even\"", "\"poisson\""), "time = 40.0", "time = 700.0");
  const Record record = run_text(edited(text, "\nids = true\ntrajectory = { steps = 100 }", ""));
  const double steps = counted(record, "steps");
  EXPECT_NEAR(counted(record, "particles-entered"), kRate * 0.07 * steps,
              4 * std::sqrt(kRate * 0.07 * steps));
  EXPECT_NE(counted(record, "particles-entered"), std::floor(kRate * 0.07 * steps));
}

/// Without collisions the gas in the box is that beyond the side, less what moves against the stream from the far side:
/// its density is F(2) of the normal distribution of whole. Entry times are uniform in a step, so no step shows, neither in
/// the first bin. After 20 all but 1e-5 of the particles have passed.
TEST(Inflows, FillTheBoxAsTheirGasWould) {
  const Record record = run_text(edited(kStream, "time = 40.0", "time = 400.0"));
  const Series& fields = record.replicas[0].series[0];
  for (const std::size_t bin : {std::size_t{0}, std::size_t{4}, std::size_t{9}}) {
    std::vector<double> density, drift;
    for (std::size_t sample = 400; sample < fields.samples(); ++sample) {
      const double* values = &fields.value[sample * 40 + 4 * bin];
      density.push_back(values[0]);
      drift.push_back(values[2]);
    }
    const Mean mean = mean_of_correlated(density), along = mean_of_correlated(drift);
    EXPECT_NEAR(mean.value, 20 * 0.9772498680518208, 4.5 * mean.standard_error) << bin;
    EXPECT_LT(mean.standard_error, 0.1);
    EXPECT_NEAR(along.value, 0.5, 4.5 * along.standard_error) << bin;
  }
}

/// A beam: as many as its velocity says, each as fast, evenly spread up to where the first can be.
TEST(Inflows, OfNoTemperatureAreABeam) {
  const Record record = run_text(
      edited(edited(kStream, "temperature = 0.5", "temperature = 0.0"), "time = 40.0", "time = 7.0"));
  EXPECT_EQ(counted(record, "particles-entered"), 700);
  EXPECT_EQ(counted(record, "particles-left"), 0);
  const Frame& frame = record.trajectory.back();
  ASSERT_EQ(frame.particles(2), 700u);
  for (std::size_t i = 0; i < 700; ++i) {
    EXPECT_EQ(frame.velocity[2 * i], 1);
    EXPECT_EQ(frame.velocity[2 * i + 1], 0.5);
    EXPECT_LE(frame.position[2 * i], 7);
  }
}

/// Along y, of the particles with these ids; -1 for those who have left.
std::vector<double> places(const Record& record, std::uint64_t most) {
  const Frame& frame = record.trajectory.back();
  const auto ids = frame.columns.get(column::id);
  std::vector<double> places(most, -1);
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (ids[i] < most) places[ids[i]] = frame.position[2 * i + 1];
  return places;
}

/// The n-th particle is the same whoever else comes in, and however the gas is cut into cells.
TEST(Inflows, DrawEachParticleFromAStreamOfItsOwn) {
  const std::string text = edited(edited(kStream, "time = 40.0", "time = 7.0"), "collisionless", "dsmc");
  const std::string coarse = edited(text, "time-step", "cells = [2, 1]\ntime-step"),
                    fine = edited(text, "time-step", "cells = [8, 5]\ntime-step"),
                    more =
                        edited(coarse, "[method]",
                               "[[inflow]]\nside = \"x-high\"\nnumber-density = 0.5\nvelocity = [-9.0, 0.0]"
                               "\ntemperature = 0.0\narrivals = \"even\"\n[method]");
  const std::string unseen = "diameter = 1e-12";  // no collisions
  const auto of = [&](const std::string& scene) {
    return run_text(edited(scene, "diameter = 0.01", unseen));
  };
  const Record one = of(coarse), two = of(fine), three = of(more);
  EXPECT_EQ(places(one, 600), places(two, 600));
  EXPECT_EQ(counted(three, "particles-entered-x-low"), counted(one, "particles-entered"));
  EXPECT_EQ(counted(three, "particles-entered-x-high"), std::floor(5 * 0.5 * 9 * 7.0));
  std::vector<double> alone = one.trajectory.back().velocity, with = three.trajectory.back().velocity;
  std::ranges::sort(alone);
  std::ranges::sort(with);
  EXPECT_TRUE(std::ranges::includes(with, alone));
}

/// Rough particles of two species that stream against each other, gravity and walls: counts, restart, momentum.
const std::string kMeeting = R"(
[run]
duration = { steps = 120 }
[domain]
dimension = 3
size = [8.0, 4.0, 1.0]
sides = { x = "open", y = "specular" }
[[species]]
name = "light"
count = 300
diameter = 0.1
tangential-restitution = 0.5
restitution = 0.8
[[species]]
name = "heavy"
count = 100
diameter = 0.2
mass = 3.0
[[wall]]
side = "y-low"
rule = "thermal"
temperature = 1.0
[[wall]]
side = "y-high"
tangential-restitution = 1.0
[[inflow]]
side = "x-low"
number-density = 12.0
velocity = [2.0, 0.0, 0.0]
temperature = 0.5
spin-temperature = 0.4
[[inflow]]
side = "x-high"
species = "heavy"
number-density = 4.0
velocity = [-1.0, 0.0, 0.0]
temperature = 0.5
arrivals = "even"
[method]
preset = "dsmc"
cells = [16, 8, 1]
time-step = 0.05
[forces]
gravity = [0.0, -0.5, 0.0]
[[observe]]
what = "fields"
grid = [1, 1, 1]
every = { steps = 10 }
[[observe]]
what = "momentum"
every = { steps = 1 }
[[observe]]
what = "wall-force"
every = { steps = 1 }
[[observe]]
what = "species-density"
grid = [1, 1, 1]
every = { steps = 120 }
[[observe]]
what = "spin-temperature"
grid = [4, 1, 1]
every = { steps = 10 }
[output]
checkpoint = { steps = 70 }
)";

/// The same as hard spheres.
std::string hard_meeting() {
  return edited(edited(kMeeting, "preset = \"dsmc\"\ncells = [16, 8, 1]", "preset = \"event-driven\""),
                "[forces]", "[initial]\npositions = \"random-without-overlap\"\n[forces]");
}

class Meeting : public testing::TestWithParam<bool> {
 protected:
  std::string text() const { return GetParam() ? hard_meeting() : kMeeting; }
};

INSTANTIATE_TEST_SUITE_P(Inflows, Meeting, testing::Bool(),
                         [](const auto& use) { return std::string(use.param ? "Hard" : "Dsmc"); });

TEST_P(Meeting, GoesOnBitwiseFromACheckpoint) {
  const Scene scene = read_scene_text(text(), "meeting.toml");
  const Record whole = run_scene(scene);
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + (GetParam() ? "inflows_test.hard.h5" : "inflows_test.h5");
  run_scene(scene, options);
  const Record resumed = resume(read_record(options.checkpoint_path));
  EXPECT_EQ(resumed.replicas[0].counters, whole.replicas[0].counters);
  for (std::size_t i = 0; i < whole.replicas[0].series.size(); ++i)
    EXPECT_EQ(resumed.replicas[0].series[i].value, whole.replicas[0].series[i].value);
  EXPECT_GT(counted(whole, "particles-entered-x-low"), 300);
  EXPECT_GT(counted(whole, "particles-left-x-high"), 50);
  EXPECT_GT(counted(whole, "collisions"), 1000);
}

/// Whoever came in or was there is inside or has left.
TEST_P(Meeting, LosesNobody) {
  const Record record = run_text(text());
  const double density = record.replicas[0].series[0].value[5 * 12];  // the last of thirteen samples
  const double waiting = GetParam() ? counted(record, "particles-waiting") : 0;
  EXPECT_NEAR(32 * density,
              400 + counted(record, "particles-entered") - counted(record, "particles-left") - waiting, 1e-9);
}

/// The momentum along x changes by what passes the sides and by what the walls drag, and by nothing else.
TEST_P(Meeting, SidesAccountForTheMomentum) {
  const Record record = run_text(text());
  const auto series = [&](const std::string& name) -> const Series& {
    return *std::ranges::find(record.replicas[0].series, name,
                              [](const Series& each) { return each.quantity.name; });
  };
  const Series &momentum = series("momentum"), &force = series("wall-force");
  double given = 0;
  for (std::size_t sample = 0; sample < force.samples(); ++sample)
    for (std::size_t side = 0; side < 4; ++side) given += 0.05 * force.value[12 * sample + 3 * side];
  const double gained = momentum.value[momentum.value.size() - 3] - momentum.value[0];
  EXPECT_NEAR(gained, -given, 1e-9 * series("momentum-scale").value[0]);
  EXPECT_GT(std::abs(gained), 50);
}

/// A crowded stream of disks: cells that are displaced, full, or looked for partners in.
TEST(Inflows, WorkWithEveryWayToCollide) {
  const std::string dense = edited(edited(edited(kStream, "number-density = 20.0", "number-density = 3000.0"),
                                          "time = 40.0", "time = 2.0"),
                                   "\nids = true\ntrajectory = { steps = 100 }", "");
  for (const char* preset : {"cba", "cuba", "esmc", "hsmc", "hsmc-ramp", "hsmc-shift", "hsmc-rotated"}) {
    const Record record =
        run_text(edited(edited(dense, "preset = \"collisionless\"",
                               std::string("preset = \"") + preset + "\"\ncells = [40, 20]"),
                        "restitution = 1.0", "restitution = 0.9"));
    EXPECT_NEAR(inside(record), counted(record, "particles-entered") - counted(record, "particles-left"),
                1e-4)
        << preset;
    EXPECT_GT(counted(record, "collisions"), 1000) << preset;
  }
}

/// Dilute disks with a surface: the box is filled as their gas would fill it. Contacts make it denser by no more than the
/// fraction that the disks cover, 0.16%.
TEST(Inflows, FillTheBoxWithHardParticlesToo) {
  const Record record =
      run_text(edited(edited(kStream, "collisionless", "event-driven"), "time = 40.0", "time = 120.0"));
  std::vector<double> density;
  const Series& fields = record.replicas[0].series[0];
  for (std::size_t sample = 600; sample < fields.samples(); ++sample)
    density.push_back(fields.value[sample * 40 + 16]);
  const Mean mean = mean_of_correlated(density);
  EXPECT_NEAR(mean.value, 20 * 0.9772498680518208, 4.5 * mean.standard_error + 0.03);
  EXPECT_GT(counted(record, "collisions"), 100);
}

TEST(Inflows, FaultsShowInTheirNumbers) {
  const std::string text = edited(kStream, "time-step = 0.07", "time-step = 0.057");
  const double honest = counted(run_text(text), "particles-entered"), steps = 702;
  EXPECT_EQ(honest, std::floor(kRate * 0.057 * steps));
  EXPECT_EQ(counted(run_text(text, "inflow-remainder-dropped"), "particles-entered"),
            std::floor(kRate * 0.057) * steps);
  EXPECT_EQ(counted(run_text(text, "inflow-drift-dropped"), "particles-entered"),
            std::floor(5 * 20 * 0.5 / std::sqrt(2 * M_PI) * 0.057 * steps));
  EXPECT_EQ(counted(run_text(text, "inflows-draw-maxwellian"), "particles-entered"), honest);
}

TEST(Inflows, ArePlannedWithWhatTheVacuumLacks) {
  const Plan planned = plan(read_scene_text(kStream, "stream.toml"));
  EXPECT_EQ(planned.particles, 1000u);
  EXPECT_THAT(planned.used, testing::IsSupersetOf({"inflows", "open sides"}));
  // f(-2) / f(2) with f(t) = s f(t/s) - U F(-U/s): (0.02699548 - 0.02275013) / 1.00424535.
  EXPECT_THAT(planned.warnings,
              testing::Contains(testing::AllOf(testing::HasSubstr("open side x-high, a vacuum"),
                                               testing::HasSubstr("0.0042 times"))));
}

/// More than a step can take, where the length of steps is not known beforehand.
TEST(Inflows, StopAtAFlood) {
  std::string text = edited(kMeeting, "time-step = 0.05", "time-step = { cell-fraction = 0.5 }");
  text = edited(text, "velocity = [2.0, 0.0, 0.0]\ntemperature = 0.5",
                "velocity = [2.0, 0.0, 0.0]\ntemperature = 1e17");
  EXPECT_THROW(run_text(text), RunError);
}

}  // namespace
}  // namespace sandglass::inflows_test
