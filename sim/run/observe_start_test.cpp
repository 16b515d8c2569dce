#include "sim/base/error.hpp"
#include "sim/run/change_scene.hpp"
#include "sim/run/test_run_text.hpp"

#include <gtest/gtest.h>

// Observers with a `start`: as the run without it, from then on.

namespace sandglass::observe_start_test {
namespace {

const std::string kScene = R"(run.duration = { steps = 40 }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "dsmc", cell-size = 5.0, time-step = 0.1 }
species = [ { count = 300, restitution = 0.9 } ]
observe = [ { what = "energy", every = { steps = 4 } }, { what = "pressure", every = { steps = 4 } },
            { what = "crossings", position = 5.0, bins = 4, every = { steps = 4 } }, { what = "collisions", every = { steps = 4 } } ]
output.checkpoint = { steps = 6 }
)";

std::string late(const std::string& start) {
  std::string text = kScene;
  for (std::size_t at = text.find("{ steps = 4 } }"); at != std::string::npos;
       at = text.find("{ steps = 4 } }", at + 1))
    text.insert(at + std::string("{ steps = 4 }").size(), ", start = " + start);
  return text;
}

std::vector<Series> series_of(const Record& record) { return record.replicas.front().series; }

/// The last samples of a series, as many as the other has, are its own.
void expect_ends_with(const Series& all, const Series& late, std::size_t first) {
  const std::size_t size = all.quantity.size(), skip = all.samples() - late.samples();
  for (std::size_t i = first; i < late.samples(); ++i) {
    EXPECT_EQ(late.step[i], all.step[skip + i]) << all.quantity.name;
    for (std::size_t k = 0; k < size; ++k)
      EXPECT_EQ(late.value[i * size + k], all.value[(skip + i) * size + k]) << all.quantity.name;
  }
}

TEST(ObserveStart, SamplesAreThoseOfTheWholeRunFromThenOn) {
  const auto whole = series_of(run_text(kScene));
  for (const char* start : {"{ steps = 20 }", "{ time = 2.0 }"}) {
    const auto cut = series_of(run_text(late(start)));
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
      const bool of_an_interval = whole[i].step.front() > 0;
      EXPECT_EQ(cut[i].step.front(), of_an_interval ? 24u : 20u) << whole[i].quantity.name;
      expect_ends_with(whole[i], cut[i], 0);
    }
  }
}

/// Between two marks of the cadence: one sample at once, and an interval that begins there.
TEST(ObserveStart, BeginsBetweenTwoMarks) {
  const auto whole = series_of(run_text(kScene)), cut = series_of(run_text(late("{ steps = 22 }")));
  EXPECT_EQ(cut[0].step.front(), 22u);
  EXPECT_EQ(cut[0].step[1], 24u);
  EXPECT_EQ(cut[1].step.front(), 24u);
  for (const Series& series : whole)
    for (const Series& other : cut)
      if (series.quantity.name == other.quantity.name) expect_ends_with(series, other, 1);
  const std::string two_steps = edited(kScene, "{ steps = 4 }", "{ steps = 22 }");
  EXPECT_EQ(cut[0].value.front(), series_of(run_text(two_steps))[0].value[1]);
}

/// The run is cut in two before or after the start, by a duration that is then made longer.
TEST(ObserveStart, GoesOnFromCheckpointsBeforeAndAfter) {
  const Scene scene = read_scene_text(late("{ time = 2.0 }"), "late.toml");
  const auto whole = series_of(run_scene(scene));
  for (const std::uint64_t cut : {std::uint64_t{10}, std::uint64_t{30}}) {
    Scene first = scene;
    first.run.duration.steps = cut;
    first.output.checkpoint->every = static_cast<double>(cut);
    RunOptions options;
    options.checkpoint_path = testing::TempDir() + "observe_start.checkpoint.h5";
    run_scene(first, options);
    Record checkpoint = read_record(options.checkpoint_path);
    change_scene(checkpoint, scene, {"a longer duration"});
    const auto again = series_of(resume(checkpoint));
    for (std::size_t i = 0; i < again.size(); ++i)
      EXPECT_EQ(again[i].value, whole[i].value) << again[i].quantity.name;
  }
}

TEST(ObserveStart, BeyondTheEndIsRefused) {
  try {
    read_scene_text(late("{ steps = 41 }"), "late.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'observe.start' is 41, beyond 'run.duration', 40"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace sandglass::observe_start_test
