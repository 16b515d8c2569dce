#include "sim/base/statistics.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::statistics_test {
namespace {

using Generator = std::mt19937_64;

/// x' = memory x + noise with unit variance: integrated correlation time (1+memory)/(1-memory)/2 samples.
std::vector<double> autoregressive(Generator& generator, std::size_t count, double memory) {
  std::normal_distribution<double> normal;
  std::vector<double> series(count);
  double x = normal(generator);
  for (double& sample : series) {
    sample = x;
    x = memory * x + std::sqrt(1 - memory * memory) * normal(generator);
  }
  return series;
}

struct Coverage {
  double one = 0, two = 0;  ///< fraction of intervals of 1 and 1.96 standard errors that hold the true mean 0
};

Coverage coverage_of_correlated(std::size_t count, double memory, int trials) {
  Generator generator(7);
  Coverage coverage;
  for (int trial = 0; trial < trials; ++trial) {
    const Mean mean = mean_of_correlated(autoregressive(generator, count, memory));
    coverage.one += std::abs(mean.value) < mean.standard_error;
    coverage.two += std::abs(mean.value) < 1.96 * mean.standard_error;
  }
  return {coverage.one / trials, coverage.two / trials};
}

/// 3.9 binomial standard deviations (one false alarm in 1e4) and one percent for the finite series.
double allowance(double probability, int trials) {
  return 3.9 * std::sqrt(probability * (1 - probability) / trials) + 0.01;
}

TEST(MeanOfIndependent, MatchesHandCalculation) {
  const Mean mean = mean_of_independent(std::vector<double>{1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(mean.value, 2.5);
  EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(5.0 / 3 / 4));
  EXPECT_DOUBLE_EQ(mean.degrees_of_freedom, 3);
}

TEST(MeanOfIndependent, OneSampleHasNoError) {
  EXPECT_TRUE(std::isnan(mean_of_independent(std::vector<double>{1}).standard_error));
}

TEST(MeanOfCorrelated, CoversAtStatedRate) {
  constexpr int trials = 1500;
  for (double memory : {0.0, 0.5, 0.8, 0.9}) {
    const Coverage coverage = coverage_of_correlated(3000, memory, trials);
    EXPECT_NEAR(coverage.one, 0.6827, allowance(0.6827, trials)) << "memory " << memory;
    EXPECT_NEAR(coverage.two, 0.95, allowance(0.95, trials)) << "memory " << memory;
  }
}

TEST(MeanOfCorrelated, FindsTheCorrelationTime) {
  Generator generator(3);
  const Mean mean = mean_of_correlated(autoregressive(generator, 200000, 0.9));
  const double expected = 200000.0 / 19;  // (1 + 0.9) / (1 - 0.9) samples per independent one
  EXPECT_NEAR(mean.effective_samples / expected, 1, 0.1);
}

TEST(MeanOfCorrelated, ConstantSeriesHasNoError) {
  const Mean mean = mean_of_correlated(std::vector<double>(20, 3.0));
  EXPECT_EQ(mean.value, 3);
  EXPECT_EQ(mean.standard_error, 0);
}

TEST(MeanOfCorrelated, NotANumberStaysVisible) {
  std::vector<double> series(20, 3.0);
  series[4] = std::nan("");
  EXPECT_TRUE(std::isnan(mean_of_correlated(series).value));
  EXPECT_TRUE(std::isnan(mean_of_correlated(series).standard_error));
}

TEST(Average, AddsErrorsInQuadrature) {
  const Mean mean = average(std::vector<Mean>{{1, 0.3, 10, 9}, {2, 0.4, 20, 19}});
  EXPECT_DOUBLE_EQ(mean.value, 1.5);
  EXPECT_DOUBLE_EQ(mean.standard_error, 0.25);
}

TEST(Jackknife, OfTheMeanIsTheMean) {
  const std::vector<double> samples{1, 4, 2, 8};
  const auto mean_of = [&](std::span<const std::size_t> chosen) {
    double sum = 0;
    for (std::size_t i : chosen) sum += samples[i];
    return sum / static_cast<double>(chosen.size());
  };
  const Mean jack = jackknife(samples.size(), mean_of);
  const Mean plain = mean_of_independent(samples);
  EXPECT_NEAR(jack.value, plain.value, 1e-14);
  EXPECT_NEAR(jack.standard_error, plain.standard_error, 1e-14);
}

TEST(FitLine, ExactDataGiveExactLine) {
  const std::vector<double> x{0, 1, 2, 5}, y{1, 3, 5, 11}, error{1, 2, 1, 3};
  const LineFit fit = fit_line(x, y, error);
  EXPECT_NEAR(fit.intercept, 1, 1e-13);
  EXPECT_NEAR(fit.slope, 2, 1e-13);
  EXPECT_NEAR(fit.chi_square, 0, 1e-20);
}

TEST(FitLine, ErrorsMatchTheScatterOfReplicates) {
  Generator generator(11);
  std::normal_distribution<double> normal;
  const std::vector<double> x{0, 1, 2, 3}, error{0.1, 0.2, 0.1, 0.3};
  constexpr int trials = 4000;
  double squares = 0, stated = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> y(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = 1 - 2 * x[i] + error[i] * normal(generator);
    const LineFit fit = fit_line(x, y, error);
    squares += (fit.slope + 2) * (fit.slope + 2);
    stated = fit.slope_error;
  }
  EXPECT_NEAR(std::sqrt(squares / trials) / stated, 1, 3.9 / std::sqrt(2.0 * trials));
}

}  // namespace
}  // namespace sandglass::statistics_test
