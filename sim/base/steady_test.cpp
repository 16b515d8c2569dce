#include "sim/base/steady.hpp"

#include "sim/base/random.hpp"

#include <cmath>
#include <limits>

#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

namespace sandglass::steady_test {
namespace {

std::vector<double> noise(std::size_t count, std::uint64_t index) {
  Random random(StreamKey(31, Purpose::velocities, 0, 0), index);
  boost::random::normal_distribution<double> normal;
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(normal(random));
  return values;
}

/// `height` e^(-i/length) on top of noise.
std::vector<double> decay(double height, double length, std::size_t count, std::uint64_t index) {
  std::vector<double> values = noise(count, index);
  for (std::size_t i = 0; i < count; ++i) values[i] += height * std::exp(-static_cast<double>(i) / length);
  return values;
}

/// The cut by its definition, sums anew for each.
std::size_t slow_cut(const std::vector<double>& row) {
  std::vector<double> means;
  for (std::size_t i = 0; i + 5 <= row.size(); i += 5)
    means.push_back((row[i] + row[i + 1] + row[i + 2] + row[i + 3] + row[i + 4]) / 5);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t cut = 0; cut <= means.size() / 2; ++cut) {
    const auto length = static_cast<double>(means.size() - cut);
    double mean = 0, squares = 0;
    for (std::size_t i = cut; i < means.size(); ++i) mean += means[i] / length;
    for (std::size_t i = cut; i < means.size(); ++i) squares += (means[i] - mean) * (means[i] - mean);
    if (squares / (length * length) < least) {
      least = squares / (length * length);
      best = cut;
    }
  }
  return 5 * best;
}

TEST(SteadyFrom, IsTheCutOfTheDefinition) {
  for (std::uint64_t index = 0; index < 50; ++index) {
    const std::vector<double> row = decay(20, 30, 203, index);
    EXPECT_EQ(steady_from({row}), slow_cut(row));
  }
}

/// The mean of what is left is biased by less than it is uncertain, 1/sqrt(300).
TEST(SteadyFrom, LeavesATransientOut) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    const std::size_t from = steady_from({decay(100, 20, 400, index)});
    EXPECT_GE(from, 60u);
    EXPECT_LE(from, 200u);
  }
}

/// The transient of one of three quantities, each in units of its own, is seen.
TEST(SteadyFrom, LooksAtEveryRow) {
  std::vector<double> large = noise(400, 7);
  for (double& value : large) value *= 1e9;
  EXPECT_GE(steady_from({large, decay(100, 20, 400, 8), noise(400, 9)}), 60u);
}

TEST(SteadyFrom, TakesAllOfAShortOrConstantRow) {
  EXPECT_EQ(steady_from({}), 0u);
  EXPECT_EQ(steady_from({decay(100, 2, 19, 0)}), 0u);
  EXPECT_EQ(steady_from({std::vector<double>(100, 3.0)}), 0u);
}

TEST(SteadyFrom, PassesOverWhatIsNotFinite) {
  std::vector<double> broken = noise(400, 3);
  broken[17] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> good = decay(100, 20, 400, 4);
  EXPECT_EQ(steady_from({broken, good}), steady_from({good}));
}

TEST(Drifts, SeesASlope) {
  std::vector<double> row = noise(400, 1);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] += 0.01 * static_cast<double>(i);
  EXPECT_TRUE(drifts(row));
  EXPECT_TRUE(drifts(decay(1000, 100, 400, 2)));
}

/// 4 errors: 6e-5 of honest series, and a little more since the errors are themselves estimated.
TEST(Drifts, IsQuietAboutNoise) {
  int false_alarms = 0;
  for (std::uint64_t index = 0; index < 1000; ++index) false_alarms += drifts(noise(200, index)) ? 1 : 0;
  EXPECT_LE(false_alarms, 3);
}

TEST(Drifts, IsQuietAboutRoundingAndShortSeries) {
  std::vector<double> row(100, 1.0);
  for (std::size_t i = 50; i < 100; ++i) row[i] += 1e-12;
  EXPECT_FALSE(drifts(row));
  EXPECT_FALSE(drifts(decay(1000, 10, 19, 0)));
}

}  // namespace
}  // namespace sandglass::steady_test
