#include "sim/physics/wall_motion.hpp"

#include <gtest/gtest.h>

namespace sandglass::wall_motion_test {
namespace {

TEST(PlaneMotion, IsASineOnADrift) {
  const PlaneMotion plane{1, 2, 0.5, 0.25, 0};  // period 4
  EXPECT_NEAR(plane.at(0), 1, 1e-15);
  EXPECT_NEAR(plane.at(1), 3.5, 1e-15);
  EXPECT_NEAR(plane.at(3), 6.5, 1e-15);
  EXPECT_NEAR(plane.velocity_at(0), 2 + 0.5 * M_PI / 2, 1e-15);
  EXPECT_NEAR(plane.velocity_at(1), 2, 1e-15);
}

TEST(PlaneMotion, DerivativesAreThoseOfThePosition) {
  const PlaneMotion plane{0.3, -0.2, 0.7, 1.3, 0.4};
  constexpr double h = 1e-5;
  for (double t : {0.0, 0.1, 0.35, 0.9, 2.2}) {
    EXPECT_NEAR(plane.velocity_at(t), (plane.at(t + h) - plane.at(t - h)) / (2 * h), 1e-7);
    EXPECT_NEAR(plane.acceleration_at(t), (plane.velocity_at(t + h) - plane.velocity_at(t - h)) / (2 * h),
                1e-6);
  }
}

TEST(PlaneMotion, GoesOnFromAnyTime) {
  const PlaneMotion plane{0.3, -0.2, 0.7, 1.3, 0.4}, later = plane.from(17.3);
  for (double t : {0.0, 0.4, 2.0}) {
    EXPECT_NEAR(later.at(t), plane.at(17.3 + t), 1e-13);
    EXPECT_NEAR(later.velocity_at(t), plane.velocity_at(17.3 + t), 1e-12);
  }
}

/// A billion whole cycles change nothing.
TEST(PlaneMotion, KeepsItsPhase) {
  const PlaneMotion plane{0, 0, 1, 2, 0.5};
  EXPECT_NEAR(plane.at(0.5e9 + 0.125), plane.at(0.125), 1e-15);
}

TEST(WallMotion, MovesAlongAndAcross) {
  const WallMotion<2> wall{{3, 1}, 0.5, 0.25, 0};
  const Vector<2> up(0, 1);
  EXPECT_NEAR(wall.along(up, 2).at(1), 3.5, 1e-15);
  EXPECT_LT((wall.velocity_at(up, 1) - Vector<2>(3, 1)).norm(), 1e-15);
  EXPECT_LT((wall.velocity_at(up, 2) - Vector<2>(3, 1 - 0.25 * M_PI)).norm(), 1e-15);
}

}  // namespace
}  // namespace sandglass::wall_motion_test
