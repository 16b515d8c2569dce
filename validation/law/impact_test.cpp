#include "validation/law/impact.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::impact_test {
namespace {

constexpr double kCoefficients[] = {-40, -1, -2e-3, -5e-4, 0, 1e-7, 5e-4, 2e-3, 0.3, 0.9, 0.99};

/// Integral of `weight` times the distribution from b = `low` on; on the disk over rings.
double mean_of(int dimension, double c, double low, double high,
               const std::function<double(double)>& weight) {
  const double a = impact_normalisation(dimension, c);
  return quadrature::integral(
      [=](double b) {
        const double ring = dimension == 2 ? 1 : 2 * std::numbers::pi * b;
        return ring * weight(b) * a / (1 - c * b * b);
      },
      low, high);
}

double lowest(int dimension) { return dimension == 2 ? -1 : 0; }

TEST(ImpactDistribution, IsNormalised) {
  for (int dimension : {2, 3})
    for (double c : kCoefficients)
      EXPECT_NEAR(mean_of(dimension, c, lowest(dimension), 1, [](double) { return 1; }), 1, 1e-9) << c;
}

TEST(ImpactDistribution, DissipatesTheMeanOfTheNormalShare) {
  for (int dimension : {2, 3})
    for (double c : kCoefficients) {
      const double mean = mean_of(dimension, c, lowest(dimension), 1, [](double b) { return 1 - b * b; });
      const double even = dimension == 2 ? 2.0 / 3 : 0.5;
      EXPECT_NEAR(impact_dissipation_ratio(dimension, c), mean / even, 1e-9) << c;
    }
}

TEST(ImpactDistribution, CumulativeIsItsIntegral) {
  for (int dimension : {2, 3})
    for (double c : kCoefficients)
      for (double b : {0.2, 0.77}) {
        const double below = mean_of(dimension, c, lowest(dimension), b, [](double) { return 1; });
        EXPECT_NEAR(impact_cumulative(dimension, c, b), below, 1e-9) << c;
      }
}

TEST(ImpactDistribution, QuantileInvertsTheCumulative) {
  for (int dimension : {2, 3})
    for (double c : kCoefficients) {
      for (double share : {0.03, 0.5, 0.81})
        EXPECT_NEAR(impact_cumulative(dimension, c, impact_quantile(dimension, c, share)), share, 1e-12) << c;
      EXPECT_NEAR(impact_quantile(dimension, c, 0), lowest(dimension), 1e-12);
      EXPECT_NEAR(impact_quantile(dimension, c, 1), 1, 1e-12);
    }
}

// Mueller 2001, sec. 3.6.1: c -> 0 is p(b) = 0.5.
TEST(ImpactDistribution, IsEvenForMolecularChaos) {
  EXPECT_DOUBLE_EQ(impact_normalisation(2, 0), 0.5);
  EXPECT_DOUBLE_EQ(impact_normalisation(3, 0), 1 / std::numbers::pi);
  for (int dimension : {2, 3}) EXPECT_DOUBLE_EQ(impact_dissipation_ratio(dimension, 0), 1);
}

}  // namespace
}  // namespace sandglass::law::impact_test
