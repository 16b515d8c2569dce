#include "validation/law/fluctuation.hpp"

#include "validation/law/state.hpp"

#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::law {
namespace {

TEST(CountVariance, OfPointsIsBinomial) {
  for (int dimension : {2, 3}) {
    const Gas points{.dimension = dimension, .fraction = 0};
    EXPECT_DOUBLE_EQ(count_variance(points, 200 * 0.3, 0.3), 200 * 0.3 * 0.7);
  }
}

// Two parts of a closed box share its particles: the same variance from either side, none for the whole.
TEST(CountVariance, IsThatOfTheRestOfTheBox) {
  const Gas gas{.dimension = 2, .fraction = 0.4};
  EXPECT_NEAR(count_variance(gas, 100, 0.2), count_variance(gas, 400, 0.8), 1e-12);
  EXPECT_EQ(count_variance(gas, 500, 1), 0);
}

/// Weights e^(-F) of splitting particles between two parts of an isothermal box, F from the pressure alone.
TEST(CountVariance, IsThatOfTheFreeEnergyOfTwoParts) {
  for (int dimension : {2, 3}) {
    Gas gas{.dimension = dimension, .fraction = 0.3};
    const double total = 40000, share = 0.25;
    // Free energy per particle over T beyond the ideal: integral of (Z - 1)/nu, by Simpson's rule from `gas.fraction`.
    const auto excess = [&](double fraction) {
      const auto slope = [&](double at) {
        return (compressibility_factor({.dimension = dimension, .fraction = at}) - 1) / at;
      };
      const double width = fraction - 0.3;
      return width / 6 * (slope(0.3) + 4 * slope(0.3 + width / 2) + slope(fraction));
    };
    double weights = 0, sum = 0, square = 0;
    for (double count = 9000; count <= 11000; ++count) {
      double exponent = 0;
      for (auto [n, part] : {std::pair(count, share), std::pair(total - count, 1 - share)}) {
        const double density = n / (total * part);
        exponent -= n * (std::log(density) - 1) + n * excess(0.3 * density);
      }
      const double weight = std::exp(exponent - total);
      weights += weight;
      sum += weight * (count - 10000);
      square += weight * (count - 10000) * (count - 10000);
    }
    const double variance = square / weights - std::pow(sum / weights, 2);
    EXPECT_NEAR(count_variance(gas, 10000, share) / variance, 1, 2e-3);  // beyond Gauss: O(1/count)
  }
}

/// Mueller (3.11)-(3.12), as they stand.
std::vector<double> power_spectrum(const std::vector<double>& samples) {
  const std::size_t count = samples.size();
  std::vector<double> power;
  const auto amplitude = [&](std::size_t k) {
    std::complex<double> sum = 0;
    for (std::size_t j = 0; j < count; ++j)
      sum += samples[j] * std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(j * k % count) /
                                              static_cast<double>(count));
    return std::norm(sum);
  };
  for (std::size_t k = 1; k < count / 2; ++k)
    power.push_back((amplitude(k) + amplitude(count - k)) / static_cast<double>(count * count));
  return power;
}

TEST(WhiteSpectrum, OfIndependentSamplesIsFlat) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal(3, 2);
  std::vector<double> mean(31, 0);
  constexpr int runs = 4000;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> samples(64);
    for (double& sample : samples) sample = normal(generator);
    const std::vector<double> power = power_spectrum(samples);
    for (std::size_t k = 0; k < power.size(); ++k) mean[k] += power[k] / runs;
  }
  const double level = white_spectrum_level(4, 64);
  // Each line is exponential: one standard error is level/sqrt(runs); 4.5 of them, 31 lines.
  for (double power : mean) EXPECT_NEAR(power, level, 4.5 * level / std::sqrt(runs));
}

}  // namespace
}  // namespace sandglass::law
