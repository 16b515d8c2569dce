#include "validation/suite/sweep.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::sweep_test {
namespace {

Outcome outcome_of(double value, double standard_error) {
  Outcome outcome;
  outcome.checks.emplace_back();
  outcome.checks[0].evidence.value = value;
  outcome.checks[0].evidence.standard_error = standard_error;
  return outcome;
}

SweepResult swept(const std::string& knob, const std::vector<double>& knobs,
                  const std::function<Outcome(double)>& run) {
  static Sweep sweep;
  sweep = {};
  sweep.knob = knob;
  std::vector<Outcome> outcomes{outcome_of(1, 0.001)};
  for (double value : knobs) {
    sweep.points.push_back({value, {}});
    outcomes.push_back(run(value));
  }
  return evaluate_sweep(Case{}, sweep, outcomes);
}

TEST(Sweep, FindsTheOrderOfAKnownError) {
  const SweepResult result =
      swept("time-step", {0.1, 0.2, 0.4, 0.8}, [](double dt) { return outcome_of(1 + dt * dt, 0.001); });
  EXPECT_NEAR(result.order, 2, 1e-9);
  EXPECT_GT(result.order_error, 0);
}

TEST(Sweep, PointsInTheNoiseDoNotCount) {
  const SweepResult result = swept("time-step", {0.01, 0.2, 0.4}, [](double dt) {
    return outcome_of(dt < 0.1 ? 1.002 : 1 + dt * dt, 0.001);
  });
  EXPECT_NEAR(result.order, 2, 1e-9);
}

TEST(Sweep, NoOrderFromNoiseAlone) {
  const SweepResult result =
      swept("time-step", {0.1, 0.2, 0.4}, [](double) { return outcome_of(1.001, 0.001); });
  EXPECT_TRUE(std::isnan(result.order));
}

TEST(Sweep, ReplicasAreFollowedByTheirErrorBar) {
  const SweepResult result =
      swept("replicas", {4, 16, 64}, [](double r) { return outcome_of(1.5, 1 / std::sqrt(r)); });
  EXPECT_NEAR(result.order, -0.5, 1e-9);
  EXPECT_DOUBLE_EQ(result.points.at(0).error, 0.5);
}

}  // namespace
}  // namespace sandglass::sweep_test
