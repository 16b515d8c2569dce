#include "sim/physics/first_approach.hpp"
#include "sim/physics/obstacle_flight.hpp"

#include <gtest/gtest.h>

namespace sandglass::obstacle_flight_exact_test {
namespace {

TEST(TimeToObstacle, WorkedByHand) {
  const Vector<2> down(0, -2), none(0, 0);
  // Dropped from 5 on a disk of radius 1: 4 = t^2.
  EXPECT_NEAR(time_to_obstacle<2>({0, 5}, none, down, 1), 2, 1e-15);
  // Thrown up from 5 with 3: 5 + 3 t - t^2 = 1.
  EXPECT_NEAR(time_to_obstacle<2>({0, 5}, {0, 3}, down, 1), 4, 1e-15);
  // From below, not high enough.
  EXPECT_EQ(time_to_obstacle<2>({0, -5}, {0, 3}, down, 1), kNever);
  // Over the disk, at the sides never nearer than 2.
  EXPECT_EQ(time_to_obstacle<2>({2, 5}, {0, 3}, down, 1), kNever);
  // Straight at a sphere, and past it.
  EXPECT_NEAR(time_to_obstacle<3>({3, 0.6, 0}, {-2, 0, 0}, Vector<3>::Zero(), 1), 1.1, 1e-15);
  EXPECT_EQ(time_to_obstacle<3>({3, 0, 1.1}, {-2, 0, 0}, Vector<3>::Zero(), 1), kNever);
  EXPECT_EQ(time_to_obstacle<3>({3, 0, 0}, Vector<3>::Zero(), Vector<3>::Zero(), 1), kNever);
}

TEST(TimeToObstacle, OverlapThatGrowsIsNow) {
  const Vector<2> none(0, 0), down(0, -1);
  EXPECT_EQ(time_to_obstacle<2>({0, 0.9}, {0, -1}, none, 1), 0);
  EXPECT_EQ(time_to_obstacle<2>({0, 0.9}, {0, -1}, down, 1), 0);
  EXPECT_EQ(time_to_obstacle<2>({0, 0.9}, {0, 1}, none, 1), kNever);
  EXPECT_EQ(time_to_obstacle<2>({0, 0.9}, none, down, 1), 0);
  EXPECT_NEAR(time_to_obstacle<2>({0, 0.9}, {0, 0.1}, down, 1), 0.1, 1e-15);  // when it turns
}

}  // namespace
}  // namespace sandglass::obstacle_flight_exact_test
