#include "sim/base/statistics.hpp"
#include "validation/judge/judge.hpp"
#include "validation/judge/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

// Calibration both ways: a right model fails at the declared rate, a wrong one is caught at the predicted
// rate.

namespace sandglass::calibration_test {
namespace {

constexpr int trials = 20000;

/// Fraction of verdicts that are not a pass over fresh experiments.
template <class Experiment>
double failure_rate(const Confidence& confidence, Experiment experiment) {
  std::mt19937_64 generator(5);
  int failures = 0;
  for (int trial = 0; trial < trials; ++trial)
    failures += judge(experiment(generator), confidence, false).verdict == Verdict::fail;
  return static_cast<double>(failures) / trials;
}

double binomial_allowance(double rate) { return 3.9 * std::sqrt(rate * (1 - rate) / trials); }

/// The mean of `count` normal samples of unit variance around `truth`, held against zero.
struct MeanOfSamples {
  double truth;
  std::size_t count;
  Evidence operator()(std::mt19937_64& generator) const {
    std::normal_distribution<double> normal(truth, 1);
    std::vector<double> samples(count);
    for (double& sample : samples) sample = normal(generator);
    const Mean mean = mean_of_independent(samples);
    Evidence evidence;
    evidence.value = mean.value;
    evidence.standard_error = mean.standard_error;
    evidence.degrees_of_freedom = mean.degrees_of_freedom;
    return evidence;
  }
};

/// The largest of k standard normal deviations.
struct LargestOfMany {
  int count;
  Evidence operator()(std::mt19937_64& generator) const {
    std::normal_distribution<double> normal;
    Evidence evidence;
    evidence.standard_error = 1;
    evidence.comparisons = count;
    for (int i = 0; i < count; ++i) {
      const double deviation = normal(generator);
      if (std::abs(deviation) > std::abs(evidence.value)) evidence.value = deviation;
    }
    return evidence;
  }
};

TEST(Calibration, RightModelFailsAtTheDeclaredRate) {
  for (std::size_t samples : {3, 8, 100})
    for (double rate : {0.01, 0.1})
      EXPECT_NEAR(failure_rate({rate}, MeanOfSamples{0, samples}), rate, binomial_allowance(rate)) << samples;
}

/// A truth that lies on the bound itself is the worst right model: it fails at the declared rate, and no more.
TEST(Calibration, TruthOnItsBoundFailsAtTheDeclaredRate) {
  for (const Expectation kind : {Expectation::at_least, Expectation::at_most}) {
    const auto on_the_bound = [kind](std::mt19937_64& generator) {
      Evidence evidence = MeanOfSamples{0, 8}(generator);
      evidence.kind = kind;
      return evidence;
    };
    EXPECT_NEAR(failure_rate({0.05}, on_the_bound), 0.05, binomial_allowance(0.05));
  }
}

TEST(Calibration, ManyComparisonsShareOneRate) {
  for (int comparisons : {2, 6, 40})
    EXPECT_NEAR(failure_rate({0.02}, LargestOfMany{comparisons}), 0.02, binomial_allowance(0.02))
        << comparisons;
}

TEST(Calibration, WrongModelIsCaughtWithThePredictedPower) {
  constexpr double rate = 0.01;
  constexpr std::size_t samples = 400;
  const double shift = 3.0 / std::sqrt(static_cast<double>(samples));  // three standard errors
  const double z = two_sided_quantile(rate, 0);
  const double power = 0.5 * std::erfc((z - 3) / std::sqrt(2.0)) + 0.5 * std::erfc((z + 3) / std::sqrt(2.0));
  // Student's quantile with 399 degrees of freedom exceeds the normal one by 0.010, which costs 0.4% of
  // power.
  EXPECT_NEAR(failure_rate({rate}, MeanOfSamples{shift, samples}), power, binomial_allowance(power) + 0.004);
}

TEST(Calibration, SystematicPartOnlyLowersTheFalseAlarms) {
  const auto allowed = [](std::mt19937_64& generator) {
    Evidence evidence = MeanOfSamples{0.1, 100}(generator);
    evidence.budget.systematic = 0.1;  // the shift is exactly what the budget allows
    return evidence;
  };
  EXPECT_LE(failure_rate({0.02}, allowed), 0.01 + binomial_allowance(0.01));
}

}  // namespace
}  // namespace sandglass::calibration_test
