#include "sim/method/region_weights.hpp"

#include <gtest/gtest.h>

namespace sandglass::region_weights_test {
namespace {

/// Cells of 1 x 0.5; the plain weight is 2.
Scene with_regions() {
  Scene scene;
  scene.domain.dimension = 2;
  scene.domain.size = {4, 3};
  scene.method.weight = 2;
  std::get<DsmcOptions>(scene.method.options).cells = {4, 6};
  scene.regions = {{{0, 1}, {4, 2}, 0.5}, {{2, 0}, {3, 1}, 8}};
  return scene;
}

TEST(RegionWeights, BelongToCells) {
  const RegionWeights<2> weights(with_regions());
  ASSERT_EQ(weights.of_cells().size(), 24u);
  EXPECT_EQ(weights.at({0.1, 0.9}), 2);
  EXPECT_EQ(weights.at({0.1, 1.1}), 0.5);
  EXPECT_EQ(weights.at({3.9, 1.9}), 0.5);
  EXPECT_EQ(weights.at({2.5, 0.5}), 8);
  EXPECT_EQ(weights.at({2.5, 2.5}), 2);
  EXPECT_EQ(weights.lightest(), 0.5);
}

/// Of 12 units of area 4 have the weight 0.5, one 8 and seven 2; along x-low a third 0.5, two thirds 2.
TEST(RegionWeights, HaveMeans) {
  const RegionWeights<2> weights(with_regions());
  EXPECT_NEAR(weights.mean_inverse(), (4 * 2 + 1 / 8.0 + 7 * 0.5) / 12, 1e-15);
  const auto side = weights.along(0, false);
  EXPECT_EQ(side.lightest, 0.5);
  EXPECT_NEAR(side.mean_inverse, (2 + 2 * 0.5) / 3, 1e-15);
  EXPECT_EQ(weights.along(1, true).lightest, 2);
  EXPECT_EQ(weights.along(1, true).mean_inverse, 0.5);
}

}  // namespace
}  // namespace sandglass::region_weights_test
