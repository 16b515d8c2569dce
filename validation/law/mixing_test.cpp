#include "validation/law/mixing.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::law::mixing_test {
namespace {

const PairRepulsion kHard{1000, 2, 5, 0, 20, 30}, kSoft{1, 2, 2, 0.1, 5, 10}, kOdd{3, 1, 0, 0.2, 4, 9};

TEST(Mixing, WorkIsTheIntegralOfTheAcceleration) {
  for (const PairRepulsion& law : {kHard, kSoft, kOdd})
    for (const double share : {0.05, 0.3, 0.8}) {
      const double distance = share * law.cutoff, middle = std::max(distance, law.diameter);
      const auto force = [&](double r) { return repulsion_acceleration(law, 7, r); };
      const double expected = quadrature::integral(force, middle, law.cutoff) +
                              (distance < middle ? quadrature::integral(force, distance, middle) : 0);
      EXPECT_NEAR(repulsion_work(law, 7, distance) / expected, 1, 1e-9);
    }
}

/// Hard disks turn by 2 acos(b/d): a core steep enough is one, as large as the distance at which it stops them.
TEST(Mixing, DeflectionOfASteepCoreIsThatOfHardDisks) {
  const PairRepulsion steep{1e-3, 2, 400, 0, 1, 2};
  for (const double b : {0.2, 0.5, 0.9})
    EXPECT_NEAR(deflection_angle(steep, 1, 1, b), 2 * std::acos(b / turning_distance(steep, 1, 1, 0)), 0.01)
        << b;
}

/// Nothing to turn: a straight line.
TEST(Mixing, DeflectionWithoutRepulsionIsZero) {
  EXPECT_NEAR(deflection_angle({0, 2, 5, 0, 20, 30}, 1, 1, 10), 0, 1e-8);
}

/// Against a fine integration of the orbit (midpoint method, the twin of the quadrature).
TEST(Mixing, DeflectionIsThatOfTheOrbit) {
  for (const auto& [law, speed, impact] :
       {std::tuple{kHard, 400.0, 5.0}, std::tuple{kHard, 400.0, 25.0}, std::tuple{kSoft, 3.0, 1.0}}) {
    double x = -1.5 * law.cutoff, y = impact, vx = speed, vy = 0;
    const double dt = 2e-6 * law.cutoff / speed;
    const auto push = [&law = law](double px, double py) {
      const double r = std::hypot(px, py);
      return repulsion_acceleration(law, 35, r) / r;
    };
    while (std::hypot(x, y) < 1.8 * law.cutoff) {
      const double mx = x + dt / 2 * vx, my = y + dt / 2 * vy, a = push(mx, my);
      vx += dt * a * mx;
      vy += dt * a * my;
      x = mx + dt / 2 * vx;
      y = my + dt / 2 * vy;
    }
    EXPECT_NEAR(std::atan2(vy, vx), deflection_angle(law, 35, speed, impact), 2e-5);
  }
}

/// Deep in an unsoftened core the work is alpha M d^beta r^(2 - q)/(q - 2) but for that of the shell.
TEST(Mixing, StableStepOfADeepCore) {
  for (const double beta : {5.0, 10.0, 20.0}) {
    const PairRepulsion law{1, 2, beta, 0, 20, 21};
    const double mass = 20, speed = 200, q = 2 + beta;
    const double turn = 20 * std::pow(2 * mass / ((q - 2) * speed * speed), 1 / (q - 2));
    EXPECT_NEAR(turning_distance(law, mass, speed, 0), turn, 1e-3 * turn);
    EXPECT_NEAR(stable_step(law, mass, speed), 2 * M_SQRT2 * turn / (speed * std::sqrt((q - 1) * (q - 2))),
                2e-3 * turn / speed);
  }
}

TEST(Mixing, CageFrequencyIsTheSlopeOfTheForce) {
  const double a = 10, width = 1e-4;
  const double slope =
      (repulsion_acceleration(kHard, 1, a + width) - repulsion_acceleration(kHard, 1, a - width)) /
      (2 * width);
  EXPECT_NEAR(std::pow(cage_frequency(kHard, 1, a), 2) / (-2 * slope), 1, 1e-8);
}

TEST(Mixing, LeapfrogPlaceIsThatOfTheSteps) {
  for (const double angle : {0.1, 1.9, 2.0, 2.02}) {
    double x = 1, v = -0.5 * angle * angle;
    for (int n = 1; n <= 30; ++n) {
      x += v;
      v -= angle * angle * x;
      EXPECT_NEAR(x, leapfrog_place(angle, n), 1e-6 * (1 + std::abs(x))) << angle << ' ' << n;
    }
  }
}

TEST(Mixing, WallFactorIsTheMeanOverOvershoots) {
  const auto factor = [](double s) { return s / (s + 1e-3); };
  EXPECT_NEAR(listed_wall_factor(0.05, 1e-3), quadrature::integral(factor, 0, 0.05) / 0.05, 1e-9);
}

}  // namespace
}  // namespace sandglass::law::mixing_test
