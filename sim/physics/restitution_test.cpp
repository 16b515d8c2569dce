#include "sim/physics/restitution.hpp"

#include <gtest/gtest.h>

namespace sandglass::restitution_test {
namespace {

TEST(Restitution, IsConstantWithoutAReferenceSpeed) {
  for (double speed : {0.0, 1e-300, 1.0, 1e300}) EXPECT_EQ(Restitution{0.7}(speed), 0.7);
  EXPECT_EQ(Restitution{}(2), 1);
}

TEST(Restitution, OfBizonHasItsLimits) {
  const Restitution r{0.7, 2};
  EXPECT_EQ(r(0), 1);
  EXPECT_NEAR(r(1e-40), 1, 1e-15);
  EXPECT_EQ(r(2), 0.7);
  EXPECT_EQ(r(50), 0.7);
  EXPECT_NEAR(r(2 * (1 - 1e-12)), 0.7, 1e-11);  // continuous
}

/// (1/16)^(3/4) = 1/8 and (81/256)^(3/4) = 27/64, by hand.
TEST(Restitution, OfBizonTakesThePowerThreeQuarters) {
  EXPECT_NEAR((Restitution{0.6, 16}(1)), 1 - 0.4 / 8, 1e-15);
  EXPECT_NEAR((Restitution{0.2, 256}(81)), 1 - 0.8 * 27 / 64, 1e-15);
}

TEST(Restitution, OfBizonFallsWithSpeed) {
  const Restitution r{0.3, 1};
  for (int i = 0; i < 100; ++i) EXPECT_GT(r(0.01 * i), r(0.01 * (i + 1)));
}

}  // namespace
}  // namespace sandglass::restitution_test
