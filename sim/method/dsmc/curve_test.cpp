#include "sim/method/dsmc/curve.hpp"

#include <gtest/gtest.h>

namespace sandglass::dsmc::curve_test {
namespace {

TEST(Curve, IsStraightBetweenItsPointsAndConstantBeyond) {
  const Curve curve{{1, 2, 4}, {10, 20, 0}};
  EXPECT_EQ(curve.at(0), 10);
  EXPECT_EQ(curve.at(1), 10);
  EXPECT_EQ(curve.at(1.5), 15);
  EXPECT_EQ(curve.at(2), 20);
  EXPECT_EQ(curve.at(3), 10);
  EXPECT_EQ(curve.at(4), 0);
  EXPECT_EQ(curve.at(9), 0);
  EXPECT_EQ((Curve{{1}, {5}}.at(0)), 5);
  EXPECT_TRUE(Curve{}.empty());
}

}  // namespace
}  // namespace sandglass::dsmc::curve_test
