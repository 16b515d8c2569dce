#include "validation/suite/apart.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

#include <atomic>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace sandglass::apart_test {
namespace {

const std::atomic<bool> go_on = false;

/// Why `work` did not end well; empty when it did.
std::string trouble(const std::function<void()>& work, double cpu_seconds = 10) {
  try {
    run_apart(work, cpu_seconds, &go_on);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(Apart, WorkIsDoneElsewhere) {
  int here = 0;
  EXPECT_EQ(trouble([&here] { here = 1; }), "");
  EXPECT_EQ(here, 0);
}

TEST(Apart, ErrorsKeepTheirWords) {
  EXPECT_EQ(trouble([] { throw InputError("no such side"); }), "error: no such side");
  EXPECT_EQ(trouble([] { throw std::logic_error("nobody foresaw it"); }), "nobody foresaw it");
}

TEST(Apart, CrashesAreErrors) {
  EXPECT_THAT(trouble([] { std::raise(SIGKILL); }), testing::HasSubstr("killed by signal 9"));
  EXPECT_EQ(trouble([] { _exit(7); }), "it ended with exit code 7");
}

TEST(Apart, LoopsWithoutEndAreErrors) {
  const auto spin = [] {
    for (std::atomic<bool> end = false; !end;) continue;
  };
  EXPECT_THAT(trouble(spin, 1), testing::HasSubstr("after 1 s of CPU time"));
  EXPECT_THAT(trouble([] { pause(); }, 0.05), testing::HasSubstr("after 1 s by the clock"));
}

TEST(Apart, StopInterrupts) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(run_apart([] { pause(); }, 10, &stop), Interrupted);
  EXPECT_THROW(run_apart([] { throw Interrupted("by a signal"); }, 10, &go_on), Interrupted);
}

constexpr const char* kScene =
    "run = { replicas = 2, duration = { steps = 20 } }\ndomain = { dimension = 2, size = [10.0, 10.0] }\n"
    "species = [{ count = 100 }]\nmethod = { preset = \"dsmc\", time-step = 0.1 }\n"
    "observe = [{ what = \"energy\", every = { steps = 1 } }]\n";

TEST(Apart, RecordIsThatOfThisProcess) {
  const Scene scene = read_scene_text(kScene, "scene.toml");
  const Record here = run_scene(scene), apart = run_scene_apart(scene, {});
  EXPECT_EQ(apart.scene, here.scene);
  ASSERT_EQ(apart.replicas.size(), 2U);
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(apart.replicas[i].counters, here.replicas[i].counters);
    EXPECT_EQ(apart.replicas[i].series.front().value, here.replicas[i].series.front().value);
  }
}

TEST(Apart, MoreWorkMayTakeLonger) {
  Scene scene = read_scene_text(kScene, "scene.toml");
  EXPECT_NEAR(cpu_limit(scene), 60 + 2 + 1e-5 * 2 * 20 * 100, 1e-9);
  scene.run.replicas = 200;
  EXPECT_NEAR(cpu_limit(scene), 60 + 200 + 1e-5 * 200 * 20 * 100, 1e-9);
}

}  // namespace
}  // namespace sandglass::apart_test
