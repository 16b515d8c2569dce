#include "sim/run/sources.hpp"

#include "sim/base/error.hpp"
#include "sim/run/test_run_text.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::sources_test {
namespace {

/// Particles that stop where they land, a frame a step.
const std::string kFloor = R"(
[run]
duration = { time = 30.0 }
[domain]
dimension = 2
size = [10.0, 40.0]
sides.y = "specular"
[[species]]
count = 0
diameter = 0.1
[[wall]]
side = "y-low"
restitution = 0.0
[[source]]
rate = 1.3
height = 8.0
centre = [6.0]
width = [2.0]
[method]
preset = "collisionless"
time-step = 0.1
[forces]
gravity = [0.0, -1.0]
[output]
ids = true
trajectory = { steps = 1 }
)";

/// Coordinate of the particle with this id; not a number where it is not in the frame.
double coordinate(const Frame& frame, std::uint64_t id, std::size_t axis) {
  const auto ids = frame.columns.get(column::id);
  const auto at = std::ranges::find(ids, id);
  return at == ids.end() ? std::nan("")
                         : frame.position[2 * static_cast<std::size_t>(at - ids.begin()) + axis];
}

double highest(const Record& record) {
  double highest = 0;
  for (const Frame& frame : record.trajectory)
    for (std::size_t i = 0; i < frame.particles(2); ++i)
      highest = std::max(highest, frame.position[2 * i + 1]);
  return highest;
}

TEST(Sources, BringInAsManyAsTheirRateSays) {
  const Record record = run_text(kFloor);
  ASSERT_EQ(record.trajectory.size(), 301u);
  for (const Frame& frame : record.trajectory)
    ASSERT_EQ(static_cast<double>(frame.particles(2)), std::floor(1.3 * frame.time)) << frame.time;
  EXPECT_EQ(record.replicas[0].counters.at("particles-poured"), 39);
}

/// Where nothing is, no centre of mass is: its samples begin with the first particle.
TEST(Sources, FillABoxThatHadNoCentreOfMass) {
  const Record record = run_text(kFloor + "[[observe]]\nwhat = \"centre-of-mass\"\nevery = { steps = 1 }\n");
  const Series& series = record.replicas[0].series[0];
  ASSERT_EQ(series.samples(), 301u - 8);
  EXPECT_EQ(series.step.front(), 8u) << "rate 1.3, steps of 0.1: the first comes at 0.77";
  EXPECT_EQ(record.estimates[0].value.size(), 1u);
}

/// The first frame has no particle, the last one most.
TEST(Sources, TheirRecordReadsBack) {
  const Record record = run_text(kFloor);
  const std::string path = testing::TempDir() + "sources_test.h5";
  write_record(path, record);
  const Record read = read_record(path);
  ASSERT_EQ(read.trajectory.size(), record.trajectory.size());
  for (std::size_t i = 0; i < record.trajectory.size(); ++i) {
    ASSERT_EQ(read.trajectory[i].position, record.trajectory[i].position);
    ASSERT_EQ(read.trajectory[i].velocity, record.trajectory[i].velocity);
  }
}

TEST(Sources, EndAfterTheirCount) {
  const Record record = run_text(edited(kFloor, "rate = 1.3\nheight = 8.0\ncentre = [6.0]\nwidth = [2.0]",
                                        "rate = 25.0\ncentre = [6.0, 9.0]\ncount = 17"));
  EXPECT_EQ(record.trajectory[3].particles(2), 7u);  // more than one a step
  EXPECT_EQ(record.trajectory.back().particles(2), 17u);
}

TEST(Sources, TheirFaultPoursLess) {
  EXPECT_EQ(run_text(kFloor, "source-rate-minus-10-percent").trajectory.back().particles(2), 35u);
}

/// Three fall at any time, from the same place: the fall takes 4 time units.
TEST(Sources, DoNotClimbOnWhatTheyPour) {
  const Record record = run_text(kFloor);
  std::uint64_t next = 0;
  for (const Frame& frame : record.trajectory)
    for (; next < frame.particles(2); ++next) {
      ASSERT_EQ(coordinate(frame, next, 1), 8) << frame.time;
      ASSERT_GE(coordinate(frame, next, 0), 5);
      ASSERT_LT(coordinate(frame, next, 0), 7);
    }
  EXPECT_EQ(next, 39u);
}

/// Who bounces is part of the pile on its way up: each time to r^2 of the height it came from, in all H / (1 - r^2).
TEST(Sources, StayBelowABoundAboveBouncingParticles) {
  const Record record = run_text(edited(kFloor, "restitution = 0.0", "restitution = 0.6"));
  EXPECT_GT(highest(record), 8.5);
  EXPECT_LT(highest(record), 8 / (1 - 0.36));
}

/// One rises and is the pile, one falls and is not.
TEST(Sources, StandAboveTheHighestOfThePile) {
  const std::string given =
      "[initial]\npositions = 'given'\n[[particle]]\nposition = [1.0, 20.0]\nvelocity = [0.0, -3.0]\n"
      "[[particle]]\nposition = [2.0, 5.0]\nvelocity = [0.0, 5.0]\n[output]";
  const Record record = run_text(edited(edited(kFloor, "[output]", given), "count = 0\n", ""));
  EXPECT_NEAR(coordinate(record.trajectory[8], 2, 1), 5 + 5 * 0.8 - 0.5 * 0.8 * 0.8 + 8, 1e-12);
}

/// Disks with a surface that are poured faster than they spread.
const std::string kCrowd = R"(
[run]
duration = { time = 20.0 }
[domain]
dimension = 2
size = [12.0, 30.0]
sides.y = "specular"
[[species]]
count = 0
restitution = 0.9
[[wall]]
side = "y-low"
restitution = 0.5
[[source]]
rate = 40.0
count = 100
centre = [6.0, 15.0]
width = [4.0, 1.0]
velocity = [0.0, -4.0]
[method]
preset = "event-driven"
time-step = 0.05
collapse-guard = "contact-time"
contact-time = 0.01
[forces]
gravity = [0.0, -1.0]
[output]
ids = true
trajectory = { steps = 1 }
checkpoint = { steps = 90 }
)";

/// Smallest distance of two disks, around the periodic x.
double nearest(const Frame& frame) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < frame.particles(2); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double x = frame.position[2 * i] - frame.position[2 * j];
      nearest = std::min(nearest, std::hypot(x - 12 * std::round(x / 12),
                                             frame.position[2 * i + 1] - frame.position[2 * j + 1]));
    }
  return nearest;
}

TEST(Sources, PourHardParticlesOnlyWhereThereIsRoom) {
  const Record record = run_text(kCrowd);
  for (std::size_t i = 1; i < record.trajectory.size(); ++i) {
    const Frame& frame = record.trajectory[i];
    ASSERT_LE(static_cast<double>(frame.particles(2)), std::min(40 * frame.time, 100.0) + 1e-9);
    ASSERT_GE(nearest(frame), 1 - 1e-12) << frame.time;
  }
  EXPECT_LT(record.trajectory[50].particles(2), 90u) << "a hundred are due at 2.5";
  EXPECT_EQ(record.trajectory.back().particles(2), 100u) << "who waited has come in";
  EXPECT_GT(record.replicas[0].counters.at("sources-refused"), 10);
}

TEST(Sources, PourHardParticlesOnBitwise) {
  const Scene scene = read_scene_text(kCrowd, "crowd.toml");
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + "sources_test.crowd.h5";
  run_scene(scene, options);
  const Record whole = run_scene(scene), resumed = resume(read_record(options.checkpoint_path));
  EXPECT_EQ(resumed.replicas[0].counters, whole.replicas[0].counters);
  EXPECT_EQ(resumed.trajectory.back().position, whole.trajectory.back().position);
}

/// Above a pile of disks that have come to rest.
TEST(Sources, RiseWithThePileOfHardParticles) {
  const Record record =
      run_text(edited(edited(kCrowd, "rate = 40.0", "rate = 5.0\nheight = 5.0"),
                      "centre = [6.0, 15.0]\nwidth = [4.0, 1.0]", "centre = [6.0]\nwidth = [4.0]"));
  EXPECT_GE(record.trajectory.back().particles(2), 99u);
  EXPECT_GT(highest(record), 5 + 99 / 12.0 * 0.7);
}

TEST(PileHeight, LeavesOutWhoFallsFasterThanPoured) {
  const std::vector<Phase<2>> particles = {
      {{1, 9}, {0, -3}}, {{1, 7}, {0, -2}}, {{1, 4}, {5, 1}}, {{1, 2}, {0, 0}}};
  View<2> view;
  view.particles = particles;
  view.box = {10, 10};
  EXPECT_EQ(pile_height(view, 1, true, 2), 7);
  EXPECT_EQ(pile_height(view, 1, true, 0), 4);
  EXPECT_EQ(pile_height(view, 1, true, 3), 9);
  EXPECT_EQ(pile_height(view, 1, false, 0.5), 8);  // gravity up: heights count from the high end
  view.particles = std::span(particles).first(3);
  EXPECT_EQ(pile_height(view, 1, false, 0.5), 3);  // who rises falls
  view.particles = {};
  EXPECT_EQ(pile_height(view, 1, true, 0), 0);
}

/// The place of a particle is its own, whatever the step, and however many come in it.
TEST(Sources, TheTimeStepMovesNoParticleSideways) {
  const std::string several = edited(kFloor, "rate = 1.3\nheight = 8.0\ncentre = [6.0]\nwidth = [2.0]",
                                     "rate = 25.0\ncentre = [6.0, 9.0]\nwidth = [2.0, 0.0]\ncount = 39");
  for (const std::string& text : {kFloor, several}) {
    const Record one = run_text(text), other = run_text(edited(text, "time-step = 0.1", "time-step = 0.02"));
    for (std::uint64_t id = 0; id < 39; ++id)
      ASSERT_EQ(coordinate(one.trajectory.back(), id, 0), coordinate(other.trajectory.back(), id, 0));
  }
}

/// Under gravity up, with the floor on top, all stands on its head.
TEST(Sources, FallUpAsTheyFallDown) {
  const std::string bounce = edited(kFloor, "restitution = 0.0", "restitution = 0.6");
  const Record down = run_text(bounce);
  const Record up = run_text(edited(edited(bounce, "y-low", "y-high"), "-1.0]", "1.0]"));
  for (std::size_t i = 0; i < down.trajectory.size(); ++i) {
    ASSERT_EQ(up.trajectory[i].particles(2), down.trajectory[i].particles(2)) << i;
    for (std::uint64_t id = 0; id < down.trajectory[i].particles(2); ++id)
      ASSERT_NEAR(coordinate(up.trajectory[i], id, 1), 40 - coordinate(down.trajectory[i], id, 1), 1e-9) << i;
  }
}

/// Little's law: a straight beam into an open side holds rate times the time of flight.
TEST(Sources, ABeamIntoAnOpenSideHoldsItsFlux) {
  std::string beam = edited(kFloor, "sides.y = \"specular\"", "sides.x = \"open\"");
  beam = edited(beam, "[[wall]]\nside = \"y-low\"\nrestitution = 0.0\n", "");
  beam = edited(beam, "height = 8.0\ncentre = [6.0]\nwidth = [2.0]",
                "centre = [2.0, 20.0]\nwidth = [0.0, 40.0]\nvelocity = [2.0, 0.0]");
  beam = edited(edited(beam, "rate = 1.3", "rate = 50.0"), "[forces]\ngravity = [0.0, -1.0]\n", "");
  const Record record = run_text(beam);
  for (std::size_t i = 41; i < record.trajectory.size(); ++i)
    ASSERT_NEAR(static_cast<double>(record.trajectory[i].particles(2)), 50 * 8 / 2.0, 50 * 0.1 + 1) << i;
  const auto& counters = record.replicas[0].counters;
  EXPECT_EQ(counters.at("particles-left-x-high") + static_cast<double>(record.trajectory.back().particles(2)),
            counters.at("particles-poured"));
  EXPECT_EQ(counters.at("particles-left-x-low"), 0);
}

void expect_run_error(const std::string& text, const std::string& words) {
  try {
    run_text(text);
    FAIL() << "ran";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(words));
  }
}

TEST(Sources, StopAtTheLidAndAtObstacles) {
  expect_run_error(edited(kFloor, "height = 8.0", "height = 41.0"),
                   "outside the box of 40; make the box higher");
  expect_run_error(
      edited(kFloor, "[[source]]", "[[obstacle]]\ncentre = [6.0, 8.0]\nradius = 2.0\n[[source]]"),
      "would appear inside an obstacle");
}

/// A heap on a table: cells of hundreds, offsets, particles that come and go.
const std::string kTable = R"(
[run]
duration = { time = 20.0 }
[domain]
dimension = 2
size = [12.0, 12.0]
sides.x = "open"
sides.y = "specular"
[[species]]
count = 0
diameter = 0.3
restitution = 0.8
[[wall]]
side = "y-low"
restitution = 0.5
rule = "random-tangential-sign"
[[source]]
rate = 20.0
height = 3.0
centre = [6.0]
width = [1.0]
velocity = [0.0, -1.0]
[[source]]
rate = 5.0
centre = [6.0, 2.0]
[method]
preset = "cba"
cell-size = 1.0
time-step = 0.05
[forces]
gravity = [0.0, -1.0]
[[observe]]
what = "energy"
every = { steps = 10 }
[[observe]]
what = "temperature"
every = { steps = 10 }
[output]
checkpoint = { steps = 170 }
)";

TEST(Sources, PourOnATableThatLosesParticlesAndGoOnBitwise) {
  const Scene scene = read_scene_text(kTable, "table.toml");
  const Record whole = run_scene(scene);
  const auto& counters = whole.replicas[0].counters;
  EXPECT_EQ(counters.at("particles-poured"), 500);
  EXPECT_GT(counters.at("particles-left-x-low"), 10);
  EXPECT_GT(counters.at("particles-left-x-high"), 10);
  EXPECT_GT(counters.at("collisions"), 100);
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + "sources_test.checkpoint.h5";
  run_scene(scene, options);
  const Record resumed = resume(read_record(options.checkpoint_path));
  EXPECT_EQ(resumed.replicas[0].counters, counters);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(resumed.replicas[0].series[i].value, whole.replicas[0].series[i].value);
}

TEST(Sources, ArePlanned) {
  const Plan planned = plan(read_scene_text(kTable, "table.toml"));
  EXPECT_EQ(planned.particles, 500u);
  EXPECT_THAT(planned.used, testing::IsSupersetOf({"sources", "open sides"}));
  EXPECT_TRUE(std::isfinite(planned.bytes_per_particle));
}

/// Of nobody there is no rate.
TEST(Sources, ArePlannedFromAnEmptyBoxOfHardParticles) {
  const Plan planned = plan(read_scene_text(kCrowd, "crowd.toml"));
  EXPECT_EQ(planned.collisions_per_particle_and_step, 0);
  EXPECT_EQ(planned.cell_size_in_mean_free_paths, 0);
}

}  // namespace
}  // namespace sandglass::sources_test
