#include "sim/run/schedule.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace sandglass::schedule_test {
namespace {

using Unit = Cadence::Unit;

std::vector<std::uint64_t> steps_due(Schedule schedule, double dt, double collisions_per_step,
                                     std::uint64_t steps, std::uint64_t first = 0) {
  std::vector<std::uint64_t> due;
  for (std::uint64_t step = first + 1; step <= steps; ++step) {
    const auto number = static_cast<double>(step);
    if (schedule.due({step, number * dt, number * collisions_per_step})) due.push_back(step);
  }
  return due;
}

using Steps = std::vector<std::uint64_t>;

TEST(Schedule, CountsSteps) {
  EXPECT_EQ(steps_due(Schedule({Unit::steps, 7}), 1, 1, 30), (Steps{7, 14, 21, 28}));
}

/// 0.1 cannot be written in binary: marks must neither be early nor a step late.
TEST(Schedule, CountsTimeInSpiteOfRounding) {
  const Steps due = steps_due(Schedule({Unit::time, 1}), 0.1, 1, 1000);
  ASSERT_EQ(due.size(), 100u);
  for (std::size_t i = 0; i < due.size(); ++i) EXPECT_EQ(due[i], 10 * (i + 1));
}

TEST(Schedule, CountsSummedTimeInSpiteOfRounding) {
  Schedule schedule({Unit::time, 0.3});
  double time = 0;
  int due = 0;
  for (std::uint64_t step = 1; step <= 30'000; ++step) due += schedule.due({step, time += 0.1, 0});
  EXPECT_EQ(due, 10'000);
}

TEST(Schedule, CountsCollisionsPerParticle) {
  EXPECT_EQ(steps_due(Schedule({Unit::collisions, 0.5}), 1, 0.2, 10), (Steps{3, 5, 8, 10}));
}

TEST(Schedule, SeveralMarksInOneStepAreOneSample) {
  EXPECT_EQ(steps_due(Schedule({Unit::time, 0.1}), 1, 1, 4), (Steps{1, 2, 3, 4}));
}

TEST(Schedule, ResumesWithoutTheMarksBefore) {
  for (Cadence cadence :
       {Cadence{Unit::steps, 7}, Cadence{Unit::time, 0.3}, Cadence{Unit::collisions, 0.5}}) {
    const Steps whole = steps_due(Schedule(cadence), 0.1, 0.2, 50);
    for (std::uint64_t stop = 0; stop < 50; ++stop) {
      Schedule resumed(cadence);
      const auto number = static_cast<double>(stop);
      resumed.resume({stop, number * 0.1, number * 0.2});
      Steps rest;
      for (std::uint64_t step : whole)
        if (step > stop) rest.push_back(step);
      EXPECT_EQ(steps_due(resumed, 0.1, 0.2, 50, stop), rest) << "stopped at " << stop;
    }
  }
}

TEST(Duration, EndsAtItsMark) {
  EXPECT_FALSE(finished({{}, 10, {}}, {9, 1e9, 1e9}));
  EXPECT_TRUE(finished({{}, 10, {}}, {10, 0, 0}));
  EXPECT_FALSE(finished({1.0, {}, {}}, {0, 0.9, 1e9}));
  EXPECT_TRUE(finished({1.0, {}, {}}, {0, 0.1 * 10 - 1e-15, 0}));
  EXPECT_FALSE(finished({{}, {}, 2.0}, {100, 100, 1.99}));
  EXPECT_TRUE(finished({{}, {}, 2.0}, {0, 0, 2}));
  EXPECT_DOUBLE_EQ(fraction_done({{}, {}, 2.0}, {0, 0, 0.5}), 0.25);
}

}  // namespace
}  // namespace sandglass::schedule_test
