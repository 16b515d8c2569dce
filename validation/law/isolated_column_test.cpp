#include "validation/law/isolated_column.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::law::isolated_column_test {
namespace {

constexpr int kSteps = 200;  ///< of a height, of the lid

/// The twin: point particles with m g = 1, every state of one energy equally likely. Where their heights sum up to w, the
/// kinetic energy is E - w and the velocities have a share (E - w)^(D N/2 - 1).
class Exact {
 public:
  Exact(int dimension, int particles, double lid, double energy) : step_(lid / kSteps) {
    const std::vector<double> others = sums_of_heights(particles - 1);
    const double half = 0.5 * dimension * particles;
    for (int i = 0; i <= kSteps; ++i) {
      double states = 0, kinetic = 0;
      for (std::size_t sum = 0; sum < others.size(); ++sum) {
        const double left = energy - step_ * (i + static_cast<double>(sum));
        if (left <= 0) break;
        const double share = others[sum] * std::pow(left / energy, half - 1);
        states += share;
        kinetic += share * left / half;
      }
      density_.push_back(states);
      temperature_.push_back(kinetic / states);
    }
    const double all = sum([this](std::size_t i) { return density_[i]; });
    for (double& density : density_) density /= all * step_;
  }

  double temperature(double z) const { return temperature_[at(z)]; }
  double density(double z) const { return density_[at(z)]; }  ///< integral one
  double mean_temperature() const {
    return step_ * sum([this](std::size_t i) { return density_[i] * temperature_[i]; });
  }

 private:
  std::size_t at(double z) const { return static_cast<std::size_t>(std::lround(z / step_)); }

  /// How often several heights, evenly spread over the steps, have each sum: one convolution after the other.
  static std::vector<double> sums_of_heights(int count) {
    std::vector<double> sums{1};
    for (int particle = 0; particle < count; ++particle) {
      std::vector<double> next(sums.size() + kSteps);
      for (std::size_t i = 0; i < sums.size(); ++i)
        for (int j = 0; j <= kSteps; ++j) next[i + static_cast<std::size_t>(j)] += sums[i] * end(j) / kSteps;
      sums = next;
    }
    return sums;
  }
  static double end(int i) { return i == 0 || i == kSteps ? 0.5 : 1; }

  template <class Value>
  double sum(const Value& value) const {
    double all = 0;
    for (int i = 0; i <= kSteps; ++i) all += end(i) * value(static_cast<std::size_t>(i));
    return all;
  }

  double step_;
  std::vector<double> density_, temperature_;
};

struct Error {
  double density = 0, temperature = 0;
};

Error worst_error(int dimension, int particles) {
  const double lid = 1.5;
  const Exact exact(dimension, particles, lid, particles * (0.5 * dimension + 0.6));
  const double mean = exact.mean_temperature();
  const Column column{1, mean, 1, lid};
  const IsolatedColumn shifts(column, dimension, particles);
  Error error;
  for (const double z : {0.0, 0.3, 0.75, 1.2, 1.5}) {
    const double law = std::exp(-z / mean) / mean / -std::expm1(-lid / mean);
    error.density = std::max(error.density, std::abs(exact.density(z) / law - 1 - shifts.density_shift(z)));
    error.temperature =
        std::max(error.temperature, std::abs(exact.temperature(z) / mean - 1 - shifts.temperature_shift(z)));
  }
  return error;
}

/// What is left out falls as 1/N^2: a quarter for twice as many, and far below the shifts of about 1/N.
TEST(IsolatedColumn, IsTheFirstOrderOfEqualStatesAtOneEnergy) {
  for (const int dimension : {2, 3}) {
    const Error few = worst_error(dimension, 12), many = worst_error(dimension, 24);
    EXPECT_LT(many.density, few.density / 3);
    EXPECT_LT(many.temperature, few.temperature / 3);
    EXPECT_LT(many.density, 0.1 / 24);
    EXPECT_LT(many.temperature, 0.1 / 24);
  }
}

TEST(IsolatedColumn, LargestDensityShiftIsBetweenItsNeighbours) {
  const Column column{1.3, 0.4, 1.7, 1.0};
  const IsolatedColumn shifts(column, 2, 50);
  const double z = shifts.largest_density_height();
  ASSERT_LT(z, 0.9);
  for (const double step : {-0.05, 0.05}) EXPECT_LT(shifts.density_shift(z + step), shifts.density_shift(z));
}

/// Poisson numbers counted one by one.
TEST(WeightOfCrowdedSamples, IsThatOfPoissonNumbers) {
  for (const double mean : {0.1, 2.0, 9.0}) {
    double chance = std::exp(-mean), weight = 0, weighted = 0;
    for (int n = 1; n < 60; ++n) {
      chance *= mean / n;
      weight += chance * (n - 1);
      weighted += chance * (n - 1) * n;
    }
    EXPECT_NEAR(weight_of_crowded_samples(mean), weighted / weight - mean, 1e-9) << mean;
  }
}

/// The profile of ln n + 2 B n = -w + const by Newton's method, with as many particles.
TEST(ExcludedVolume, ShiftIsTheFirstOrderOfTheProfile) {
  const Column column{1, 0.8, 1.3, 1.2};
  const double lid = 1.3 * 1.2 / 0.8, excluded = 1e-4;
  const auto density = [&](double constant, double w) {
    double n = std::exp(constant - w);
    for (int i = 0; i < 20; ++i)
      n -= (std::log(n) + 2 * excluded * n + w - constant) / (1 / n + 2 * excluded);
    return n;
  };
  double low = -3, high = 3;
  while (high - low > 1e-13) {
    const double middle = (low + high) / 2;
    const double mean = quadrature::integral([&](double w) { return density(middle, w); }, 0, lid) / lid;
    (mean < 1 ? low : high) = middle;
  }
  for (const double z : {0.0, 0.5, 1.2}) {
    const double w = 1.3 / 0.8 * z;
    const double law = lid * std::exp(-w) / -std::expm1(-lid);
    EXPECT_NEAR(density(low, w) / law - 1, excluded_volume_shift(column, excluded, z),
                10 * excluded * excluded);
  }
}

}  // namespace
}  // namespace sandglass::law::isolated_column_test
