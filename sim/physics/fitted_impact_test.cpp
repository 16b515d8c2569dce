#include "sim/physics/fitted_impact.hpp"

#include "sim/base/statistics.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::fitted_impact_test {
namespace {

/// Share of |b| below x by the midpoint rule on the density of the source, with the measure of the cross-section.
double share_below(int dimension, double c, double x) {
  constexpr int kPieces = 20000;
  double below = 0, all = 0;
  for (int i = 0; i < kPieces; ++i) {
    const double b = (i + 0.5) / kPieces, weight = (dimension == 2 ? 1 : b) / (1 - c * b * b);
    all += weight;
    if (b < x) below += weight;
  }
  return below / all;
}

template <int D>
void expect_distribution(double c) {
  Random random(StreamKey(5, Purpose::collisions, 0, 0), 0);
  constexpr int kDraws = 100'000;
  const std::array<double, 4> places = {0.2, 0.5, 0.8, 0.95};
  std::array<double, 4> below{};
  for (int i = 0; i < kDraws; ++i) {
    const double b = FittedImpact{c}.draw(uniform_impact<D>(random)).norm();
    ASSERT_LE(b, 1);
    for (std::size_t k = 0; k < places.size(); ++k) below[k] += b < places[k];
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double expected = share_below(D, c, places[k]);
    EXPECT_NEAR(below[k] / kDraws, expected, 4.5 * std::sqrt(expected * (1 - expected) / kDraws)) << c;
  }
}

TEST(FittedImpact, FollowsTheDensityOfTheSource) {
  for (const double c : {-3.0, -0.5, 1e-9, 0.3, 0.7, 0.99}) {
    expect_distribution<2>(c);
    expect_distribution<3>(c);
  }
}

TEST(FittedImpact, IsUniformInTheLimit) {
  const Vector<1> line(0.37);
  const Vector<2> disk(0.3, -0.6);
  for (const double c : {0.0, 1e-12}) {
    EXPECT_EQ(FittedImpact{c}.draw(line), line);
    EXPECT_EQ(FittedImpact{c}.draw(disk), disk);
  }
  EXPECT_NEAR(FittedImpact{1e-6}.draw(line)[0], 0.37, 1e-6);
  EXPECT_NEAR(FittedImpact{1e-6}.draw(disk)[1], -0.6, 1e-6);
}

}  // namespace
}  // namespace sandglass::fitted_impact_test
