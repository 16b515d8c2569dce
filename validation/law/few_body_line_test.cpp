#include "validation/law/few_body_line.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::law::few_body_line_test {
namespace {

constexpr std::array<double, 3> kEqual = {1, 1, 1}, kMixed = {1, 0.4, 2.5};

TEST(Collapse, EqualMassesNeedLessThanSevenMinusFourRootThree) {
  EXPECT_NEAR(collapse_restitution(kEqual), 7 - 4 * std::sqrt(3.0), 1e-15);
}

TEST(Collapse, IsWhereTheMatrixOfTwoCollisionsGetsRealEigenvalues) {
  const double r = collapse_restitution(kMixed), coupling = row_coupling(kMixed);
  // Relative velocities: left (-r, 0; a, 1), right (1, b; 0, -r), a b = (1+r)^2 c. Trace and determinant of the product.
  const double trace = (1 + r) * (1 + r) * coupling - 2 * r, determinant = r * r;
  EXPECT_NEAR(trace * trace, 4 * determinant, 1e-14);
}

/// Most collisions over all ways to start with the left pair.
double counted(const std::array<double, 3>& masses, double r) {
  double most = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 1e-9 + (i / 2000.0 - 1) * std::acos(0.0) * (1 - 1e-8);  // approaches: cos, sin
    most = std::max(most, three_in_a_row(masses, r, {std::cos(angle), 0, -std::sin(angle)}).collisions);
  }
  return most;
}

TEST(Collapse, MostCollisionsAreThoseOfTheBestStart) {
  for (double r : {0.99, 0.8, 0.3, 0.2}) {
    EXPECT_EQ(most_collisions(kEqual, r), counted(kEqual, r)) << r;
    if (r > collapse_restitution(kMixed)) {
      EXPECT_EQ(most_collisions(kMixed, r), counted(kMixed, r)) << r;
    }
  }
  EXPECT_EQ(most_collisions(kEqual, 1), 3);
  EXPECT_EQ(counted(kEqual, 1), 3);
}

TEST(Collapse, NoEndBelow) {
  const double critical = collapse_restitution(kEqual);
  EXPECT_TRUE(std::isinf(most_collisions(kEqual, critical)));
  const RowResult row = three_in_a_row(kEqual, 0.9 * critical, {1, 0, -0.4});
  EXPECT_TRUE(std::isinf(row.collisions));
  for (const double velocity : row.velocities) EXPECT_NEAR(velocity, 0.2, 1e-15);
  EXPECT_EQ(three_in_a_row(kEqual, 0.9 * critical, {1, 0, 0.7}).collisions, 1);  // the outer one escapes
  EXPECT_TRUE(std::isfinite(counted(kEqual, 1.01 * critical)));
}

// w_n = r^(n/2) (A cos(n phi) + B sin(n phi)) in units that make both pairs alike.
TEST(ThreeInARow, ApproachSpeedsFollowTheSineOfTheirPhase) {
  const double r = 0.3, a = (1 + r) / 2, phi = std::acos(a / std::sqrt(r) / 2);
  const double first = 1, second = a * first + 0.2;
  int n = 0;
  const auto approach = [&](int k) {
    const double sine = (second / std::sqrt(r) - first * std::cos(phi)) / std::sin(phi);
    return std::pow(r, k / 2.0) * (first * std::cos(k * phi) + sine * std::sin(k * phi));
  };
  while (approach(n) > 0) ++n;
  const RowResult row = three_in_a_row(kEqual, r, {1, 0, -0.2});
  EXPECT_EQ(row.collisions, n);
  // The last pair leaves with r times its approach.
  const std::size_t left = n % 2 == 1 ? 0 : 1;
  EXPECT_NEAR(row.velocities[left + 1] - row.velocities[left], r * approach(n - 1), 1e-14);
  EXPECT_NEAR(row.velocities[0] + row.velocities[1] + row.velocities[2], 0.8, 1e-14);
}

TEST(Cradle, SpeedOfTheBlow) {
  EXPECT_DOUBLE_EQ(cradle_speed(4, 1, 2), 2);
  EXPECT_DOUBLE_EQ(cradle_speed(0, 0.5, 2), 2);
  EXPECT_DOUBLE_EQ(cradle_speed(2, 0.5, 2), 2 * 0.75 * 0.75);
}

}  // namespace
}  // namespace sandglass::law::few_body_line_test
