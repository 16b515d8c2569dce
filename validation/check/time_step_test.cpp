#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"

#include <gtest/gtest.h>

namespace sandglass::time_step_test {
namespace {

using namespace synthetic;

/// 200 particles of temperature 1, so of the mean square speed 2, in cells of edge 2 that allow 0.4 of them: the average
/// pair takes dt 2 sqrt(2) / 2.
double part_over_bound(double dt) {
  Record record;
  record.scene =
      "[run]\nduration = { time = 100.0 }\n[domain]\ndimension = 2\nsize = [20.0, 20.0]\n"
      "[[species]]\ncount = 200\n[method]\npreset = \"dsmc\"\ncells = [10, 10]\n"
      "time-step = { cell-fraction = 0.4 }\n";
  record.replicas.resize(2);
  for (std::size_t replica = 0; replica < 2; ++replica) {
    Series& energy = add_series(record, replica, "energy", {});
    for (int sample = 0; sample < 5; ++sample) {
      add_sample(energy, 100 * dt * sample, {200.0});
      energy.step.back() = static_cast<std::uint64_t>(100 * sample);
    }
  }
  const Evidence evidence = run_check(find_check("step-in-cells"), record, {});
  EXPECT_EQ(evidence.kind, Expectation::at_most);
  EXPECT_EQ(evidence.expected, 0.4);
  EXPECT_NEAR(evidence.value, dt * std::sqrt(2.0), 1e-12);
  return evidence.value / evidence.expected;
}

TEST(StepInCells, IsAtMostTheFractionOfTheScene) {
  EXPECT_LT(part_over_bound(0.1), 1);
  EXPECT_GT(part_over_bound(0.5), 1);
}

}  // namespace
}  // namespace sandglass::time_step_test
