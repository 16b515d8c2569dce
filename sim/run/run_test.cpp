#include "sim/run/run.hpp"

#include "sim/base/error.hpp"
#include "sim/run/test_same.hpp"
#include "sim/run/test_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

namespace sandglass::run_test {
namespace {

const char* const kGas = R"(
title = "small gas"
[run]
seed = 5
replicas = 2
duration = { steps = 60 }
[domain]
dimension = 2
size = [20.0, 20.0]
[[species]]
area-fraction = 0.1
restitution = 0.9
[method]
preset = "cba"
cell-size = 2.5
time-step = 0.1
weight = 0.1
[initial]
temperature = 1.0
[[observe]]
what = "energy"
every = { steps = 7 }
[[observe]]
what = "pressure"
every = { time = 1.0 }
[[observe]]
what = "crossings"
axis = "x"
position = 5.0
every = { steps = 10 }
[[observe]]
what = "collisions"
every = { collisions-per-particle = 0.5 }
[output]
ids = true
trajectory = { steps = 20 }
checkpoint = { steps = 25 }
)";

Scene gas() { return read_scene_text(kGas, "gas.toml"); }

TEST(Run, IsRepeatable) { expect_same(run_scene(gas()), run_scene(gas())); }

TEST(Run, SeedMatters) {
  Scene other = gas();
  other.run.seed = 6;
  EXPECT_NE(run_scene(gas()).replicas[0].counters, run_scene(other).replicas[0].counters);
}

TEST(Run, ReplicasDiffer) {
  const Record record = run_scene(gas());
  EXPECT_NE(record.replicas[0].series[0].value, record.replicas[1].series[0].value);
}

/// 25 steps: the second checkpoint of a replica; 50 steps: the first.
Scene stream() {
  return read_scene_text(R"(
[run]
duration = { steps = 50 }
[domain]
dimension = 2
size = [20.0, 20.0]
[[species]]
number-density = 1.0
[method]
preset = "reservoir"
time-step = 1.0
[initial]
velocity = [0.3, 0.0]
[[observe]]
what = "crossings"
axis = "x"
position = 10.0
every = { steps = 10 }
)",
                         "stream.toml");
}

/// Rough disks with friction between walls, under gravity, with a collapse guard: every feature that a fault may touch.
Scene hard_disks() {
  return read_scene_text(R"(
[run]
duration = { time = 4.0 }
[domain]
dimension = 2
size = [20.0, 20.0]
sides.y = "specular"
[[wall]]
side = "y-low"
restitution = 0.9
[[species]]
area-fraction = 0.4
restitution = 0.8
tangential-restitution = 0.5
friction = 0.3
[method]
preset = "event-driven"
time-step = 0.5
collapse-guard = "contact-time"
contact-time = 0.05
[forces]
gravity = [0.0, -0.1]
[initial]
positions = "lattice"
[[observe]]
what = "energy"
every = { steps = 1 }
)",
                         "hard-disks.toml");
}

TEST(Run, ResumesBitwiseFromEveryCheckpoint) {
  const Record whole = run_scene(gas());
  const std::string path = testing::TempDir() + "run_test.checkpoint.h5";
  for (const double steps : {25.0, 50.0}) {
    Scene scene = gas();
    scene.output.checkpoint->every = steps;
    RunOptions options;
    options.checkpoint_path = path;
    run_scene(scene, options);  // leaves the last checkpoint of the second replica
    Record checkpoint = read_record(path);
    ASSERT_TRUE(checkpoint.state.has_value());
    EXPECT_EQ(checkpoint.state->step, 50u);
    EXPECT_EQ(checkpoint.replicas.size(), 1u);
    expect_same(resume(checkpoint), whole);
  }
}

/// The particles of a checkpoint stand in the cells of the coming step.
TEST(Run, ResumesBitwiseOnEveryLattice) {
  for (const CellLattice lattice : {CellLattice::shifted, CellLattice::diagonal}) {
    Scene scene = gas();
    DsmcOptions& options = std::get<DsmcOptions>(scene.method.options);
    options.lattice = lattice;
    options.excluded_volume = ExcludedVolume::cells;
    options.densest_fraction = 0.12;  // so that some cells are full
    const Record whole = run_scene(scene);
    EXPECT_GT(whole.replicas[0].counters.at("moves-refused"), 100);
    RunOptions keep;
    keep.checkpoint_path = testing::TempDir() + "run_lattice.checkpoint.h5";
    run_scene(scene, keep);
    expect_same(resume(read_record(keep.checkpoint_path)), whole);
  }
}

/// Local times, what was foreseen, spins, contact times and the draws of a thermal wall all go along.
TEST(Run, EventDrivenResumesBitwise) {
  Scene scene = hard_disks();
  scene.output.ids = true;
  Wall floor;
  floor.axis = 1;
  floor.surface.rule = SurfaceKind::thermal;
  floor.surface.temperature = 2;
  scene.walls = {floor};
  scene.observe.push_back(scene.observe.front());
  scene.observe.back().what = "impact-parameter";
  const Record whole = run_scene(scene);
  scene.output.checkpoint = Cadence{Cadence::Unit::steps, 3};
  RunOptions options;
  options.checkpoint_path = testing::TempDir() + "run_event_driven.checkpoint.h5";
  expect_same(run_scene(scene, options), whole);
  const Record checkpoint = read_record(options.checkpoint_path);
  EXPECT_EQ(checkpoint.state->step, 6u);
  expect_same(resume(checkpoint), whole);
}

TEST(Run, EventTraceHasALinePerCollisionInOrderOfTime) {
  Scene scene = hard_disks();
  scene.output.event_trace = testing::TempDir() + "run_trace.csv";
  const Record record = run_scene(scene);
  std::ifstream file(*scene.output.event_trace);
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  EXPECT_TRUE(line.starts_with("time,kind,first,second,position_x,position_y"));
  double last = 0, collisions = 0;
  while (std::getline(file, line)) {
    const double time = std::stod(line);
    EXPECT_GE(time, last);
    last = time;
    collisions += line.find(",collision,") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(collisions, record.replicas[0].counters.at("collisions"));
}

TEST(Run, StopsWhenAskedAndSaysWhere) {
  std::atomic<bool> stop{true};
  RunOptions options;
  options.stop = &stop;
  options.checkpoint_path = testing::TempDir() + "run_stop.checkpoint.h5";
  EXPECT_THROW(run_scene(gas(), options), Interrupted);
  expect_same(resume(read_record(options.checkpoint_path)), run_scene(gas()));
}

TEST(Run, ConservesMomentumAndLosesEnergyByInelasticity) {
  const Record record = run_scene(gas());
  const Series& energy = record.replicas[0].series[0];
  EXPECT_LT(energy.value.back(), 0.99 * energy.value.front());
  EXPECT_GT(energy.value.back(), 0);
}

TEST(Run, RefusesAPlaneNormalToWalls) {
  Scene scene = gas();
  scene.domain.sides[0] = {Side::specular, Side::specular};
  EXPECT_THROW(run_scene(scene), InputError);
}

TEST(Run, UnknownPlantedFaultNamesTheNearest) {
  RunOptions options;
  options.planted_fault = "offset-droped";
  try {
    run_scene(gas(), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'offset-dropped'"), std::string::npos)
        << error.what();
  }
}

/// Walls of every kind, an obstacle and gravity, for any method that takes them.
Scene surfaces(const std::string& preset) {
  Scene scene = test_scene(2, 12, 60);
  choose(scene.method, preset);
  scene.initial.positions = preset == "event-driven" ? Positions::lattice : Positions::random;
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.gravity = {0, -0.1};
  Wall floor, lid;
  floor.axis = lid.axis = 1;
  floor.surface.rule = SurfaceKind::thermal;
  floor.surface.temperature = 2;
  lid.high = true;
  lid.surface.rule = SurfaceKind::bounce_back;
  lid.surface.probability = 0.5;
  lid.surface.restitution = 0.9;
  lid.velocity = {0.5, 0};
  scene.walls = {floor, lid};
  scene.obstacles = {{{6, 6}, 1, {}}};
  scene.run.duration.steps = 400;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 400;
  return scene;
}

/// A box open along x, for any method whose number of particles may change.
Scene open_box(const std::string& preset, std::uint64_t particles) {
  Scene scene = test_scene(2, 12, particles);
  choose(scene.method, preset);
  if (preset == "event-driven")
    scene.initial.positions = Positions::lattice;
  else
    dsmc_options(scene).cells = {6, 6};
  scene.domain.sides[0] = {Side::open, Side::open};
  return scene;
}

/// Particles come in and go out.
Scene beam(const std::string& preset) {
  Scene scene = open_box(preset, 60);
  scene.sources = {{1.5, {}, {}, {6, 6}, {}, {2, 0}}};
  scene.run.duration.steps = 400;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 400;
  return scene;
}

/// Cells of which some are full, with fitted impact parameters.
Scene crowd() {
  Scene scene = test_scene(2, 12, 110);
  choose(scene.method, "hsmc-pb");
  dsmc_options(scene).cells = {4, 4};
  dsmc_options(scene).impact_coefficient = {{0}, {0.7}};
  scene.species[0].restitution = 0.8;
  scene.run.duration.steps = 400;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 400;
  return scene;
}

/// The same with cells that are the harder to enter the fuller they are, in steps of a part of a cell.
Scene falling_entry() {
  Scene scene = crowd();
  choose(scene.method, "hsmc-ramp");
  dsmc_options(scene).cells = {4, 4};
  scene.method.time_step = {{}, {}, 0.1};
  return scene;
}

/// Partners a diameter away, in cells that differ in their contact factor.
Scene at_contact() {
  Scene scene = test_scene(2, 12, 60);
  choose(scene.method, "esmc");
  dsmc_options(scene).density = DensityEstimate::cell;
  dsmc_options(scene).cells = {6, 6};
  scene.species[0].restitution = 0.8;
  scene.run.duration.steps = 200;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 200;
  return scene;
}

/// Rough particles of two kinds, between mirrors.
Scene rough_mixture() {
  Scene scene = test_scene(2, 12, 30);
  choose(scene.method, "dsmc");
  dsmc_options(scene).cells = {6, 6};
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.species[0].tangential_restitution = 0.3;
  scene.species[0].friction = 0.2;
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "other";
  scene.species[1].mass = 3;
  scene.species[1].diameter = 1.5;
  scene.run.duration.steps = 100;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 100;
  return scene;
}

/// The same, dense, by the clocks of the cells.
Scene dense_mixture() {
  Scene scene = rough_mixture();
  choose(scene.method, "cba");
  dsmc_options(scene).cells = {6, 6};
  dsmc_options(scene).pair_count = PairCount::time_counter;
  return scene;
}

/// A stream that comes in by one side and leaves by the other; in DSMC past a border between weights.
Scene passing_stream(const std::string& preset) {
  Scene scene = open_box(preset, 30);
  if (preset == "dsmc") scene.regions = {{{0, 6}, {12, 12}, 0.5}};
  scene.method.time_step.fixed = 0.1;
  scene.inflows.emplace_back();
  scene.inflows[0].number_density = 0.2;
  scene.inflows[0].velocity = {1.5, 0};
  scene.inflows[0].temperature = 1;
  scene.inflows[0].arrivals = Arrivals::even;
  scene.run.duration.steps = 100;
  scene.observe.emplace_back().what = "energy";
  scene.observe.back().cadence.every = 100;
  return scene;
}

/// A dispenser and an end that turns some back.
Scene dispensed_stream() {
  Scene scene = passing_stream("event-driven");
  scene.inflows[0].entry = InflowEntry::dispenser;
  scene.inflows[0].number_density = 0.4;
  scene.outflows.emplace_back();
  scene.outflows[0].high = true;
  scene.outflows[0].velocity = {0.5, 0};
  scene.outflows[0].temperature = 1;
  return scene;
}

double change_of_energy(const Scene& scene, const std::string& fault) {
  RunOptions options;
  options.planted_fault = fault;
  const Record changed = run_scene(scene, options), honest = run_scene(scene);
  EXPECT_EQ(changed.provenance.planted_fault, fault);
  return changed.replicas[0].series.front().value != honest.replicas[0].series.front().value;
}

/// Each collision heats, more follow, and the step would never end.
TEST(Run, OfAGasThatHeatsWithoutBoundEndsWithAReason) {
  Scene scene = rough_mixture();
  scene.run.duration.steps = 100'000;
  RunOptions options;
  options.planted_fault = "spins-reversed";
  try {
    run_scene(scene, options);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("pairs in one step"), std::string::npos) << error.what();
  }
}

/// A planted fault that changes nothing would make every mutant test worthless.
TEST(Run, EveryPlantedFaultChangesARunOfItsFamily) {
  Scene few = gas();
  choose(few.method, "cba-expected-pairs");
  dsmc_options(few).cells = {24, 24};
  few.species[0].fraction = 0.3;
  few.run.duration.steps = 300;
  Scene spread = gas();
  choose(spread.method, "cuba");
  dsmc_options(spread).random_offset = 0.5;
  std::map<std::string, std::vector<Scene>> scenes;
  for (const Scene& scene :
       {gas(), few, spread, stream(), hard_disks(), surfaces("dsmc"), surfaces("event-driven"), beam("dsmc"),
        beam("event-driven"), crowd(), falling_entry(), at_contact(), rough_mixture(), dense_mixture(),
        passing_stream("dsmc"), passing_stream("event-driven"), dispensed_stream()})
    scenes[method_family(scene)].push_back(scene);
  for (const auto& [family, examples] : scenes)
    for (const PlantedFault& fault : planted_faults(family))
      EXPECT_TRUE(std::any_of(examples.begin(), examples.end(),
                              [&](const Scene& scene) { return change_of_energy(scene, fault.name) != 0; }))
          << family << ": " << fault.name;
}

/// Collisions over a diameter have a kernel of their own.
TEST(Run, AFaultWithinACellIsRefusedWithPartnersAtContact) {
  RunOptions options;
  options.planted_fault = "bound-halved";
  EXPECT_THROW(run_scene(at_contact(), options), InputError);
}

TEST(Run, AFaultOfAnotherFamilyIsRefused) {
  RunOptions options;
  options.planted_fault = "stale-partners";
  EXPECT_THROW(run_scene(gas(), options), InputError);
}

/// A gas between a thermal wall and one that drags it along: both show in what a run measures.
TEST(Run, WallsOfTheSceneReachTheStochasticMethods) {
  Scene scene = test_scene(2, 10, 2000);
  scene.species[0].diameter = 0.1;
  scene.domain.sides[1] = {Side::specular, Side::specular};
  Wall hot;
  hot.axis = 1;
  hot.surface.rule = SurfaceKind::thermal;
  hot.surface.temperature = 4;
  Wall moving = hot;
  moving.high = true;
  moving.velocity = {3, 0};
  scene.walls = {hot, moving};
  scene.run.duration.steps = 2000;
  for (const char* what : {"temperature", "momentum"}) {
    scene.observe.emplace_back().what = what;
    scene.observe.back().cadence.every = 2000;
  }
  const Record record = run_scene(scene);
  EXPECT_GT(record.replicas[0].series[0].value.back(), 3);  // T = 1 at the start
  EXPECT_GT(record.replicas[0].series[1].value.at(record.replicas[0].series[1].quantity.size()), 1000);
}

TEST(Plan, SaysWhatIsLeftOut) {
  const Plan planned = plan(gas());
  EXPECT_EQ(planned.particles, 509u);
  EXPECT_NE(std::find(planned.left_out.begin(), planned.left_out.end(), "gravity"), planned.left_out.end());
  EXPECT_NE(std::find(planned.used.begin(), planned.used.end(), "contact factor of the local density"),
            planned.used.end());
  EXPECT_EQ(planned.steps, 60);
}

TEST(Plan, PredictsTheCollisionsOfAnElasticGas) {
  Scene scene = gas();
  scene.species[0].restitution = 1;
  scene.run.duration = {{}, 1000, {}};
  scene.run.replicas = 1;
  const Record record = run_scene(scene);
  const double measured = record.replicas[0].counters.at("collisions");
  EXPECT_NEAR(measured / plan(scene).expected_collisions, 1, 5 / std::sqrt(measured) + 0.01);
}

}  // namespace
}  // namespace sandglass::run_test
