#include "validation/check/finite_size.hpp"

#include "sim/base/statistics.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

// Five particles in 2D: the corrections are large, and a sample of the sphere itself is the reference.

namespace sandglass::finite_size_test {
namespace {

constexpr int particles = 5;
constexpr double degrees = 2 * (particles - 1);

template <class Statistic>
Mean measured(Statistic statistic) {
  synthetic::Generator generator(2);
  std::vector<double> samples;
  for (int i = 0; i < 40000; ++i)
    samples.push_back(statistic(synthetic::microcanonical(generator, particles)));
  return mean_of_independent(samples);
}

double speed_moment(const std::vector<double>& v, int order) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); i += 2) sum += std::pow(v[i] * v[i] + v[i + 1] * v[i + 1], order / 2);
  return sum / particles;
}

double component_moment(const std::vector<double>& v, int order) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); i += 2) sum += std::pow(v[i], order);
  return sum / particles;
}

void expect_within_errors(const Mean& mean, double expected) {
  EXPECT_NEAR(mean.value, expected, 4 * mean.standard_error);
}

TEST(FiniteSize, SelfNormalisedSpeedMoments) {
  for (int order : {4, 6, 8}) {
    const double maxwell = std::tgamma(1 + order / 2);  // <C^n>/<C^2>^(n/2) in 2D is (n/2)!
    const auto ratio = [&](const auto& v) {
      return speed_moment(v, order) / std::pow(speed_moment(v, 2), order / 2);
    };
    expect_within_errors(measured(ratio), maxwell * self_normalised_factor(order, degrees));
  }
}

TEST(FiniteSize, SelfNormalisedComponentMoments) {
  for (auto [order, maxwell] : {std::pair{4, 3.0}, {6, 15.0}, {8, 105.0}}) {
    const auto ratio = [order = order](const auto& v) {
      return component_moment(v, order) / std::pow(component_moment(v, 2), order / 2);
    };
    expect_within_errors(measured(ratio), maxwell * self_normalised_factor(order, particles - 1));
  }
}

TEST(FiniteSize, RelativeSpeed) {
  const auto speed = [](const auto& v) { return std::hypot(v[0] - v[2], v[1] - v[3]); };
  const double maxwell = std::sqrt(std::numbers::pi);  // mean of |v1-v2| for T/m = 1 in 2D
  expect_within_errors(measured(speed), maxwell * relative_speed_factor(degrees));
}

TEST(FiniteSize, RelativeSpeedIsContinuousWhereTheFormulaChanges) {
  EXPECT_NEAR(relative_speed_factor(0.99e6), 1 + 1 / (4 * 0.99e6), 1e-9);
  EXPECT_NEAR(relative_speed_factor(1.01e6), 1 + 1 / (4 * 1.01e6), 1e-12);
}

TEST(FiniteSize, ComponentCumulative) {
  for (double velocity : {-1.5, -0.3, 0.8, 2.0}) {
    const auto below = [&](const auto& v) { return v[0] < velocity ? 1.0 : 0.0; };
    expect_within_errors(measured(below), component_cumulative(velocity, 1, particles, 2));
  }
  EXPECT_EQ(component_cumulative(100, 1, particles, 2), 1);
  EXPECT_NEAR(component_cumulative(1, 1, 1e6, 2), 0.5 * std::erfc(-1 / std::sqrt(2.0)), 1e-6);
}

TEST(FixedCountFactor, OfADiluteGasCountsPartners) {
  for (int dimension : {2, 3}) EXPECT_NEAR(fixed_count_factor(dimension, 0.002, 100), 0.99, 1e-4);
}

TEST(FixedCountFactor, FallsOffWithDensity) {
  const double dense = 1000 * (1 - fixed_count_factor(2, 0.65, 1000));
  EXPECT_NEAR(dense, 0.41, 0.02);  // by hand: S = 1/41, d^2(nu^2 g)/dnu^2 = 193, g = 5.84
  EXPECT_LT(dense, 1000 * (1 - fixed_count_factor(2, 0.25, 1000)));
}

}  // namespace
}  // namespace sandglass::finite_size_test
