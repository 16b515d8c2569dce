#include "sim/run/placement_points.hpp"

#include "sim/base/error.hpp"
#include "sim/run/test_scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::placement_points_test {
namespace {

const StreamKey key(5, Purpose::positions, 0, 0);

Scene column(double pull) {
  Scene scene = test_scene(2, 4, 100'000);
  scene.domain.sides[1] = {Side::specular, Side::specular};
  scene.gravity = {0, pull};
  scene.species[0].mass = 2;
  scene.initial.temperature = 3;
  return scene;
}

/// Mean height of exp(-z/h) on [0, L]: h - L / (exp(L/h) - 1); its scatter is below h.
TEST(PlaceBarometrically, HasTheMeanHeightOfAnAtmosphere) {
  for (const double pull : {-1.5, 1.5, -1e-9}) {
    const Scene scene = column(pull);
    const auto points = place_barometrically<2>(scene, Room<2>(scene), 100'000, key);
    double height = 0, across = 0;
    for (const Vector<2>& point : points) {
      height += (pull < 0 ? point[1] : 4 - point[1]) / 100'000;
      across += point[0] / 100'000;
    }
    const double scale = 3 / (2 * std::abs(pull));
    const double mean = pull > -1e-6 && pull < 0 ? 2 : scale - 4 / std::expm1(4 / scale);
    EXPECT_NEAR(height, mean, 4.5 * 1.2 / std::sqrt(100'000)) << pull;
    EXPECT_NEAR(across, 2, 4.5 * 1.2 / std::sqrt(100'000));
  }
}

TEST(PlaceRandomly, StaysOutsideObstacles) {
  Scene scene = test_scene(2, 4, 20'000);
  scene.obstacles = {{{2, 2}, 1.5, {}}};
  const auto points = place_randomly<2>(Room<2>(scene), 20'000, key);
  double left = 0;
  for (const Vector<2>& point : points) {
    EXPECT_GE((point - Vector<2>(2, 2)).norm(), 1.5);
    left += point[0] < 2;
  }
  EXPECT_NEAR(left / 20'000, 0.5, 4.5 * 0.5 / std::sqrt(20'000));
}

TEST(PlaceRandomly, SaysWhenThereIsNoRoom) {
  Scene scene = test_scene(2, 4, 2);
  scene.obstacles = {{{2, 2}, 10, {}}};
  EXPECT_THROW(place_randomly<2>(Room<2>(scene), 2, key), InputError);
}

}  // namespace
}  // namespace sandglass::placement_points_test
