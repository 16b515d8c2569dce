#include "validation/law/moments.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::moments_test {
namespace {

using std::numbers::pi;

constexpr double kVariance = 0.7;
const double kFar = 20 * std::sqrt(kVariance);

double component_moment(int order) {
  return quadrature::integral(
             [=](double v) { return std::pow(v, order) * std::exp(-v * v / (2 * kVariance)); }, 0, kFar) *
         2 / std::sqrt(2 * pi * kVariance);
}

/// Integral of v^order over speeds, with the Sonine weight 1 + a2 S2; not normalised.
double speed_integral(int dimension, int order, double a2) {
  return quadrature::integral(
      [=](double v) {
        const double x = v * v / (2 * kVariance);
        const double s2 = x * x / 2 - (dimension + 2) * x / 2 + dimension * (dimension + 2) / 8.0;
        return std::pow(v, order + dimension - 1) * std::exp(-x) * (1 + a2 * s2);
      },
      0, kFar);
}

TEST(MaxwellMoments, OfOneComponentAreItsIntegrals) {
  for (int order : {0, 2, 4, 6, 8})
    EXPECT_NEAR(maxwell_component_moment(order, kVariance) / component_moment(order), 1, 1e-9);
  for (int order : {1, 3, 5, 7}) EXPECT_EQ(maxwell_component_moment(order, kVariance), 0);
}

TEST(MaxwellMoments, OfTheSpeedAreItsIntegrals) {
  for (int dimension : {1, 2, 3})
    for (int order = 0; order <= 8; ++order) {
      const double expected = speed_integral(dimension, order, 0) / speed_integral(dimension, 0, 0);
      EXPECT_NEAR(maxwell_speed_moment(dimension, order, kVariance) / expected, 1, 1e-9);
    }
}

TEST(SonineMoments, AreTheWeightedIntegrals) {
  const double a2 = -0.07;
  for (int dimension : {2, 3})
    for (int order : {0, 2, 4, 6, 8}) {
      const double expected = speed_integral(dimension, order, a2) / speed_integral(dimension, order, 0);
      EXPECT_NEAR(sonine_moment_factor(order, a2), expected, 1e-9);
    }
}

// One component is the speed times the cosine to a fixed axis: the factor is the same.
TEST(SonineMoments, OfOneComponentCarryTheSameFactor) {
  const double a2 = 0.11;
  for (int order : {2, 4, 6, 8}) {
    const auto marginal = [=](double v) {  // 2D distribution, the other component integrated out
      const double x = v * v / (2 * kVariance);
      const double s2 = (x * x + x + 0.75) / 2 - 2 * (x + 0.5) + 1;
      return std::exp(-x) * (1 + a2 * s2);
    };
    const double moment =
        quadrature::integral([=](double v) { return std::pow(v, order) * marginal(v); }, 0, kFar);
    const double norm = quadrature::integral(marginal, 0, kFar);
    EXPECT_NEAR(moment / norm / maxwell_component_moment(order, kVariance), sonine_moment_factor(order, a2),
                1e-9);
  }
}

}  // namespace
}  // namespace sandglass::law::moments_test
