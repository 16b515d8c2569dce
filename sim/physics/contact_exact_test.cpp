#include "sim/physics/contact.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Cases worked by hand.

namespace sandglass::contact_exact_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Masses 1 and 3, velocities 4 and 0, r = 1/2: 4 (1 - 3 r)/4 and 4 (1 + r)/4.
TEST(Contact, HeadOnOfUnequalMasses) {
  Vector<2> one(4, 0), two(0, 0);
  Spin<2> still(0.0), spun(2.0);
  collide<2>({{0.5}}, Vector<2>(-1, 0), {one, still, 1, 1, 0.5}, {two, spun, 1.0 / 3, 1, 1});
  EXPECT_NEAR(one[0], -0.5, 1e-15);
  EXPECT_NEAR(two[0], 1.5, 1e-15);
  EXPECT_EQ(one[1], 0);
  EXPECT_EQ(spun[0], 2);
}

/// A disk (m = 1, R = 1, I = 1/2) falls with (3, -4) on the floor. Sticking with e_t = 0: j_t = -3 / (1 + 2) = -1, so
/// that it rolls off with 2 and spin -2.
TEST(Contact, ADiskThatSticksRollsOff) {
  Vector<2> velocity(3, -4), wall(0, 0);
  Spin<2> spin(0.0), none(0.0);
  collide<2>({{0.5}, 0, kNever}, Vector<2>(0, 1), {velocity, spin, 1, 2, 1}, {wall, none, 0, 0, 0});
  EXPECT_NEAR(velocity[0], 2, 1e-15);
  EXPECT_NEAR(velocity[1], 2, 1e-15);
  EXPECT_NEAR(spin[0], -2, 1e-15);
}

/// The same with mu = 1/10: j_n = 1.5 * 4 = 6, and it slides with j_t = -0.6.
TEST(Contact, ADiskThatSlidesTakesCoulombsImpulse) {
  Vector<2> velocity(3, -4), wall(0, 0);
  Spin<2> spin(0.0), none(0.0);
  collide<2>({{0.5}, 0, 0.1}, Vector<2>(0, 1), {velocity, spin, 1, 2, 1}, {wall, none, 0, 0, 0});
  EXPECT_NEAR(velocity[0], 2.4, 1e-15);
  EXPECT_NEAR(velocity[1], 2, 1e-15);
  EXPECT_NEAR(spin[0], -1.2, 1e-15);
}

/// Perfectly rough spheres, m = 1, R = 1, I = 2/5, collide head-on in x; the first spins with 7 about z. Where they touch, its
/// surface at -x moves with -7 y; M_t = 1/(2 + 5) and j = 2 * 7 / 7 = 2 along y; spins change by 5/2 * 2 = 5, against 7.
TEST(Contact, PerfectlyRoughSpheresExchangeSpin) {
  Vector<3> one(-1, 0, 0), two(1, 0, 0);
  Spin<3> first(0, 0, 7), second(0, 0, 0);
  collide<3>({{1}, 1}, Vector<3>(1, 0, 0), {one, first, 1, 2.5, 1}, {two, second, 1, 2.5, 1});
  EXPECT_LT((one - Vector<3>(1, 2, 0)).norm(), 1e-14);
  EXPECT_LT((two - Vector<3>(-1, -2, 0)).norm(), 1e-14);
  EXPECT_LT((first - Spin<3>(0, 0, 2)).norm(), 1e-14);
  EXPECT_LT((second - Spin<3>(0, 0, -5)).norm(), 1e-14);
}

/// A belt that runs with 6 spins up a disk at rest along it: j_t = 6/3.
TEST(Contact, AMovingSurfaceDrags) {
  Vector<2> velocity(0, -1), belt(6, 0);
  Spin<2> spin(0.0), none(0.0);
  collide<2>({{1}, 0}, Vector<2>(0, 1), {velocity, spin, 1, 2, 1}, {belt, none, 0, 0, 0});
  EXPECT_LT((velocity - Vector<2>(2, 1)).norm(), 1e-15);
  EXPECT_NEAR(spin[0], 4, 1e-15);
  EXPECT_EQ(belt, Vector<2>(6, 0));
}

/// Elastic slow, inelastic fast.
TEST(Contact, RestitutionIsThatOfTheSpeedOfApproach) {
  Vector<2> velocity(0, -1), wall(0, 0);
  Spin<2> spin(0.0), none(0.0);
  collide<2>({{0.6, 16}}, Vector<2>(0, 1), {velocity, spin, 1, 2, 1}, {wall, none, 0, 0, 0});
  EXPECT_NEAR(velocity[1], 1 - 0.4 / 8, 1e-15);
}

TEST(Contact, WithoutSlipNothingHappensAlongTheSurface) {
  Vector<2> velocity(0, -1), wall(0, 0);
  Spin<2> spin(0.0), none(0.0);
  collide<2>({{1}, 0.5, 0.3}, Vector<2>(0, 1), {velocity, spin, 1, 2, 1}, {wall, none, 0, 0, 0});
  EXPECT_EQ(velocity, Vector<2>(0, 1));
  EXPECT_EQ(spin[0], 0);
}

TEST(Surface, OfAPairIsTheMean) {
  const Surface pair = mix({{0.8, 2}, -1, 0.2}, {{0.6, 1}, 0.5, 0.4});
  EXPECT_DOUBLE_EQ(pair.normal.value, 0.7);
  EXPECT_DOUBLE_EQ(pair.normal.reference_speed, 1.5);
  EXPECT_DOUBLE_EQ(pair.tangential, -0.25);
  EXPECT_DOUBLE_EQ(pair.friction, 0.3);
  EXPECT_EQ(mix({}, {}).friction, kNever);
}

}  // namespace
}  // namespace sandglass::contact_exact_test
