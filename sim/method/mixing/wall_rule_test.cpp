#include "sim/method/mixing/wall_rule.hpp"

#include <gtest/gtest.h>

namespace sandglass::mixing::wall_rule_test {
namespace {

constexpr std::uint32_t kMost = 100;

WallRule rule(double factor, double smallest = 0) { return {{100, 50}, factor, smallest}; }

/// Flown from `start` for a unit of time.
Phase<2> flown(const Vector<2>& start, const Vector<2>& velocity) { return {start + velocity, velocity}; }

void expect_near(const Vector<2>& found, const Vector<2>& expected, double error = 1e-12) {
  EXPECT_NEAR(found[0], expected[0], error);
  EXPECT_NEAR(found[1], expected[1], error);
}

/// Without a smallest length and with the factor 1 it is a mirror, at each wall.
TEST(WallRule, IsAMirror) {
  for (const auto& [start, velocity, place, after] :
       {std::array<Vector<2>, 4>{{{95, 20}, {8, 4}, {97, 24}, {-8, 4}}},
        std::array<Vector<2>, 4>{{{5, 20}, {-8, 4}, {3, 24}, {8, 4}}},
        std::array<Vector<2>, 4>{{{20, 48}, {3, 6}, {23, 46}, {3, -6}}},
        std::array<Vector<2>, 4>{{{20, 2}, {3, -6}, {23, 4}, {3, 6}}},
        std::array<Vector<2>, 4>{{{98, 48}, {6, 6}, {96, 46}, {-6, -6}}}}) {
    Phase<2> particle = flown(start, velocity);
    rule(1).turn_back(start, particle, kMost);
    expect_near(particle.position, place);
    expect_near(particle.velocity, after);
  }
}

TEST(WallRule, LeavesWhoIsInside) {
  Phase<2> particle = flown({50, 20}, {50, 30});  // onto the corner
  EXPECT_EQ(rule(0.5, 1e-3).turn_back({50, 20}, particle, kMost), 0u);
  expect_near(particle.position, {100, 50});
  expect_near(particle.velocity, {50, 30});
}

TEST(WallRule, CountsSeveralWallsInAStep) {
  Phase<2> particle = flown({50, 20}, {270, 0});
  EXPECT_EQ(rule(1).turn_back({50, 20}, particle, kMost), 3u);
  expect_near(particle.position, {80, 20});
  expect_near(particle.velocity, {-270, 0});
}

/// By hand, factor 1/2: out by 3 at a slope of 1/2. Back by 1.5; the path inside starts 1.5 slopes behind the end, not 3,
/// and ends half of that further: at 24 - 0.75 + 0.375. The slope is half of what it was, against the source's words.
TEST(WallRule, TakesItsFactorTwiceAlongTheWall) {
  Phase<2> particle = flown({95, 20}, {8, 4});
  EXPECT_EQ(rule(0.5).turn_back({95, 20}, particle, kMost), 1u);
  expect_near(particle.position, {98.5, 24 - 0.75 + 0.375});
  EXPECT_NEAR(particle.velocity.norm(), 0.5 * std::hypot(8, 4), 1e-12);
  EXPECT_NEAR(particle.velocity[1] / particle.velocity[0], -0.25, 1e-12);
}

/// The listing divides by the path and EPS: of a path s only s/(s + EPS) of the speed is left, though the factor is 1.
TEST(WallRule, LosesSpeedToTheSmallestLength) {
  for (const double out : {1e-4, 1e-3, 1e-2}) {
    Phase<2> particle{{100 + out, 20}, {50, 0}};
    rule(1, 1e-3).turn_back({99, 20}, particle, kMost);
    EXPECT_NEAR(particle.velocity[0], -50 * out / (out + 1e-3), 1e-9);
  }
}

/// Of even overshoots x over 0 to u in units of EPS the mean factor x/(x + 1) is 1 - ln(1 + u)/u.
TEST(WallRule, MeanLossOfEvenOvershoots) {
  constexpr int kPlaces = 20000;
  constexpr double kPath = 0.05, kSmallest = 1e-3;
  double sum = 0;
  for (int i = 0; i < kPlaces; ++i) {
    Phase<2> particle{{100 + kPath * (i + 0.5) / kPlaces, 20}, {50, 0}};
    rule(1, kSmallest).turn_back({100 + kPath * (i + 0.5) / kPlaces - kPath, 20}, particle, kMost);
    sum += -particle.velocity[0] / 50;
  }
  const double u = kPath / kSmallest;
  EXPECT_NEAR(sum / kPlaces, 1 - std::log1p(u) / u, 1e-6);
}

TEST(WallRule, TakesAllSpeedWithTheFactorZero) {
  Phase<2> particle = flown({95, 20}, {8, 4});
  EXPECT_EQ(rule(0, 1e-3).turn_back({95, 20}, particle, kMost), 1u);
  expect_near(particle.position, {100, 24});
  expect_near(particle.velocity, {0, 0});
}

TEST(WallRule, GivesUpOnWhoIsThrown) {
  for (const double speed : {1e6, 1e300, HUGE_VAL}) {
    Phase<2> particle = flown({50, 20}, {speed, 0});
    EXPECT_EQ(rule(1, 1e-3).turn_back({50, 20}, particle, kMost), kMost + 1) << speed;
  }
}

}  // namespace
}  // namespace sandglass::mixing::wall_rule_test
