#include "sim/run/event_trace.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "sim/run/test_hard.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::event_trace_test {
namespace {

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Event<2> collision_at(double time) {
  Event<2> event{};
  event.time = time;
  return event;
}

TEST(EventTrace, GoesOnBehindWhatItKeeps) {
  const std::string path = testing::TempDir() + "trace_goes_on.csv";
  std::uintmax_t kept = 0;
  {
    EventTrace<2> trace(path);
    trace.record(collision_at(1));
    kept = trace.flush();
    trace.record(collision_at(2));
  }
  const std::string whole = text_of(path);
  ASSERT_GT(whole.size(), kept);
  {
    EventTrace<2> trace(path, kept);
    EXPECT_EQ(trace.flush(), kept);
    trace.record(collision_at(2));
  }
  EXPECT_EQ(text_of(path), whole);
}

TEST(EventTrace, RefusesAFileThatLacksWhatTheCheckpointSays) {
  const std::string path = testing::TempDir() + "trace_short.csv";
  std::ofstream(path) << "time,kind\n";
  for (const std::string& there : {path, testing::TempDir() + "no_such_trace.csv"}) {
    try {
      EventTrace<2> trace(there, 11);
      FAIL() << there;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr(there), testing::HasSubstr("and 11 when"),
                                               testing::HasSubstr("run the scene anew")));
    }
  }
  EXPECT_EQ(text_of(path), "time,kind\n");
}

/// Hard disks for 40 steps with a checkpoint every 15; the trace is that of the first replica.
Scene traced(std::uint64_t replicas, const std::string& name) {
  Scene scene = hard_scene({12, 12}, 60);
  scene.run.duration.steps = 40;
  scene.run.replicas = replicas;
  scene.output.checkpoint = Cadence{Cadence::Unit::steps, 15};
  scene.output.event_trace = testing::TempDir() + name + ".csv";
  return scene;
}

/// Runs to the end, which leaves behind what a hard kill would at the worst: the last checkpoint and all later events.
Record last_checkpoint(const Scene& scene) {
  RunOptions options;
  options.checkpoint_path = *scene.output.event_trace + ".checkpoint.h5";
  run_scene(scene, options);
  return read_record(options.checkpoint_path);
}

TEST(EventTrace, ResumeCutsItBackToTheCheckpointAndRepeatsNoEvent) {
  const Scene scene = traced(1, "trace_killed");
  const std::string& path = *scene.output.event_trace;
  const Record checkpoint = last_checkpoint(scene);
  const std::string whole = text_of(path);
  EXPECT_EQ(checkpoint.state->step, 30U);
  const auto kept = static_cast<std::size_t>(checkpoint.state->memory.at("event-trace").at(0));
  ASSERT_LT(kept, whole.size());
  EXPECT_EQ(whole[kept - 1], '\n');
  std::ofstream(path, std::ios::app) << "1e9,collision,7";  // a line that the kill tore
  resume(checkpoint);
  EXPECT_EQ(text_of(path), whole);
}

TEST(EventTrace, ResumeInALaterReplicaLeavesThatOfTheFirstAsItIs) {
  const Scene scene = traced(2, "trace_of_two");
  const Record checkpoint = last_checkpoint(scene);
  const std::string whole = text_of(*scene.output.event_trace);
  ASSERT_EQ(checkpoint.replicas.size(), 1U);
  resume(checkpoint);
  EXPECT_EQ(text_of(*scene.output.event_trace), whole);
}

TEST(EventTrace, ResumeRefusesATraceThatIsGone) {
  const Scene scene = traced(1, "trace_gone");
  const Record checkpoint = last_checkpoint(scene);
  std::filesystem::remove(*scene.output.event_trace);
  EXPECT_THROW(resume(checkpoint), InputError);
}

}  // namespace
}  // namespace sandglass::event_trace_test
