#include "sim/base/error.hpp"
#include "sim/base/test_fuzz.hpp"
#include "sim/record/scratch.hpp"
#include "sim/run/change_scene.hpp"
#include "sim/run/test_run_text.hpp"
#include "sim/run/test_same.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Runs that break: what they have is kept, and they can go on from their last checkpoint with what mends them.

namespace sandglass::broken_run_test {
namespace {

using testing::HasSubstr;

/// Three disks in a row with restitution 0.05, below 7 - 4 sqrt(3): they collapse at t = 0.414286.
const std::string kRow = R"(run.duration = { time = 1.0 }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "event-driven", time-step = 0.1 }
species = [ { restitution = 0.05 } ]
initial.positions = "given"
particle = [ { position = [9.0, 10.0], velocity = [1.0, 0.0] }, { position = [10.2, 10.0], velocity = [0.0, 0.0] },
             { position = [11.7, 10.0], velocity = [-1.0, 0.0] } ]
observe = [ { what = "energy" } ]
output = { checkpoint = { steps = 2 }, trajectory = { steps = 1 } }
)";
const std::string kGuard = "method.collapse-guard";

struct Broken {
  std::string words;
  Record record, checkpoint;
};

Broken run_row() {
  Broken broken;
  const ScratchFolder folder;
  RunOptions options;
  options.checkpoint_path = folder / "row.checkpoint.h5";
  options.keep_broken = [&](const Record& record) {
    write_record(folder / "row.broken.h5", record);
    broken.record = read_record(folder / "row.broken.h5");
  };
  try {
    run_scene(read_scene_text(kRow, "row.toml"), options);
  } catch (const RunError& error) {
    broken.words = error.what();
  }
  broken.checkpoint = read_record(options.checkpoint_path);
  return broken;
}

Scene guarded() {
  return read_scene_text(edited(kRow, "time-step = 0.1",
                                "time-step = 0.1, collapse-guard = \"contact-time\", contact-time = 1e-3"),
                         "row.toml");
}

TEST(BrokenRun, KeepsWhatItHasMarkedAsBroken) {
  const Broken broken = run_row();
  EXPECT_THAT(broken.words, HasSubstr("inelastic collapse"));
  EXPECT_THAT(broken.record.broken, HasSubstr("step 4, time 0.4, replica 1 of 1: inelastic collapse"));
  ASSERT_EQ(broken.record.replicas.size(), 1u);
  EXPECT_EQ(broken.record.replicas[0].series[0].samples(), 5u);
  EXPECT_EQ(broken.record.trajectory.size(), 5u);
  EXPECT_FALSE(broken.record.state);
  EXPECT_EQ(broken.checkpoint.state->step, 4u);
  EXPECT_EQ(broken.checkpoint.broken, "");
}

TEST(BrokenRun, GoesOnFromItsCheckpointWithAGuard) {
  Record checkpoint = run_row().checkpoint;
  EXPECT_THROW(resume(checkpoint), RunError);
  change_scene(checkpoint, guarded(), {"--set method.collapse-guard=contact-time"});
  const Record mended = resume(checkpoint);
  EXPECT_EQ(mended.replicas[0].series[0].samples(), 11u);
  ASSERT_EQ(mended.changes.size(), 1u);
  EXPECT_EQ(mended.changes[0],
            "--set method.collapse-guard=contact-time, from step 4, time 0.4 of replica 1");
  EXPECT_THAT(mended.scene, HasSubstr("contact-time"));
  const ScratchFolder folder;
  write_record(folder / "mended.h5", mended);
  EXPECT_EQ(read_record(folder / "mended.h5").changes, mended.changes);
}

/// A guard that no contact has needed changes nothing; and it can be taken away again.
TEST(BrokenRun, AGuardThatIsNotNeededChangesNoDigit) {
  const std::string elastic = edited(kRow, "restitution = 0.05", "restitution = 0.9");
  const ScratchFolder folder;
  RunOptions options;
  options.checkpoint_path = folder / "row.checkpoint.h5";
  const Record whole = run_scene(read_scene_text(elastic, "row.toml"), options);
  Record checkpoint = read_record(options.checkpoint_path);
  const std::string guard = edited(elastic, "time-step = 0.1",
                                   "time-step = 0.1, collapse-guard = \"contact-time\", contact-time = 1e-9");
  change_scene(checkpoint, read_scene_text(guard, "row.toml"), {"on"});
  expect_same(resume(checkpoint), whole);
  checkpoint = read_record(options.checkpoint_path);
  change_scene(checkpoint, read_scene_text(guard, "row.toml"), {"on"});
  change_scene(checkpoint, read_scene_text(elastic, "row.toml"), {"off"});
  EXPECT_EQ(resume(checkpoint).changes.size(), 2u);
}

std::string refusal(const Scene& scene, std::size_t finished = 0) {
  Record checkpoint = run_row().checkpoint;
  checkpoint.replicas.resize(finished);
  try {
    change_scene(checkpoint, scene, {"x"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ChangeScene, WhatHasShapedThePastIsRefused) {
  const auto with = [](auto change) {
    Scene scene = read_scene_text(kRow, "row.toml");
    change(scene);
    return refusal(scene);
  };
  EXPECT_THAT(with([](Scene& scene) { scene.species[0].restitution = 0.5; }),
              HasSubstr("in [species] it would"));
  EXPECT_THAT(with([](Scene& scene) { scene.method.time_step.fixed = 0.2; }),
              HasSubstr("in [method] it would"));
  EXPECT_THAT(with([](Scene& scene) { scene.run.seed = 2; }), HasSubstr("in [run] it would"));
  EXPECT_THAT(with([](Scene& scene) {
                scene.given[0].velocity = {0, 0};
              }),
              HasSubstr("in [the scene] it would"));
  EXPECT_THAT(with([](Scene& scene) { scene.output.ids = true; }), HasSubstr("in [output] it would"));
  EXPECT_THAT(with([](Scene& scene) { scene.run.duration.time = 0.3; }), HasSubstr("must end later"));
  EXPECT_EQ(with([](Scene& scene) { scene.run.duration.time = 2; }), "accepted");
}

TEST(ChangeScene, ReplicasThatAreDoneBindTheOthers) {
  Scene longer = read_scene_text(kRow, "row.toml");
  longer.run.duration.time = 2;
  EXPECT_THAT(refusal(longer, 1), HasSubstr("1 of the replicas is done"));
  EXPECT_EQ(refusal(guarded(), 1), "accepted");
}

/// Observers come and go; one that stays has all its samples, one that comes those since then.
TEST(ChangeScene, ObserversMayChange) {
  const Record checkpoint = run_row().checkpoint;
  Scene scene = guarded();
  scene.observe[0].cadence = {Cadence::Unit::steps, 3};
  scene.observe.emplace_back();
  scene.observe.back().what = "pressure";
  Record changed = checkpoint;
  change_scene(changed, scene, {"observers"});
  const auto series = resume(changed).replicas[0].series;
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].step, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 6, 9}));
  EXPECT_EQ(series[1].quantity.name, "pressure");
  EXPECT_EQ(series[1].step, (std::vector<std::uint64_t>{5, 6, 7, 8, 9, 10}));
}

/// A state that is not finite does not take the place of the last good checkpoint.
TEST(BrokenRun, TheLastGoodCheckpointStays) {
  std::string text = edited(kRow, "preset = \"event-driven\"", "preset = \"collisionless\"");
  text = edited(text, "species = [ { restitution = 0.05 } ]",
                "species = [ { mass = 1 } ]\nforces.gravity = [1e307, 0.0]");
  text = edited(text, "time = 1.0", "time = 1000.0");
  text = edited(text, "observe = [ { what = \"energy\" } ]", "");
  EXPECT_THROW(run_text(text), std::exception);
}

/// A step that does not end is given up; there is no new checkpoint, and what there was before it is kept.
TEST(BrokenRun, AStepThatDoesNotEndIsGivenUp) {
  const std::string text = edited(edited(edited(kRow, "restitution = 0.05", "restitution = 1.0"),
                                         "velocity = [1.0, 0.0]", "velocity = [1e90, 1e90]"),
                                  "time-step = 0.1", "time-step = 0.5");
  RunOptions options;
  options.stop = &stop_request.asked();
  Record kept;
  options.keep_broken = [&](const Record& record) { kept = record; };
  const Deadline deadline(0.1);
  try {
    run_scene(read_scene_text(text, "fast.toml"), options);
    FAIL() << "ended";
  } catch (const Interrupted& stop) {
    EXPECT_THAT(stop.what(), HasSubstr("stopped within the step after step 0"));
    EXPECT_FALSE(stop.everywhere());
  }
  EXPECT_EQ(kept.replicas.at(0).series.at(0).samples(), 1u);
  EXPECT_THAT(kept.broken, HasSubstr("did not end in time"));
}

}  // namespace
}  // namespace sandglass::broken_run_test
