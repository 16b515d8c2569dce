#include "validation/law/falling.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::law::falling_test {
namespace {

/// Points in a column that never touch each other, each bouncing on the floor with r = 0.9, by their bounces.
struct Column {
  std::vector<double> height, velocity;
  double gravity = 2, impulse = 0, lost = 0;

  double mean(const std::vector<double>& values) const {
    double sum = 0;
    for (double value : values) sum += value / static_cast<double>(values.size());
    return sum;
  }

  void fly(double time) {
    for (std::size_t i = 0; i < height.size(); ++i) {
      double left = time;
      for (double hit = fall_time(height[i], velocity[i], gravity); hit < left;
           hit = fall_time(height[i], velocity[i], gravity)) {
        const double impact = gravity * hit - velocity[i];
        impulse += 1.3 * 1.9 * impact;
        lost += 1.3 * 0.19 * impact * impact / 2;
        height[i] = 0;
        velocity[i] = 0.9 * impact;
        left -= hit;
      }
      height[i] += left * (velocity[i] - gravity * left / 2);
      velocity[i] -= gravity * left;
    }
  }
};

Column some_column() {
  Column column;
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> height(0.5, 4), velocity(-1, 1);
  for (int i = 0; i < 20; ++i) {
    column.height.push_back(height(generator));
    column.velocity.push_back(velocity(generator));
  }
  return column;
}

FallingParticles law_of(const Column& column) {
  return {20, 1.3, column.gravity, column.mean(column.height), column.mean(column.velocity)};
}

TEST(FallingParticles, FallFreelyUntilTheFirstHitsTheFloor) {
  Column column = some_column();
  const FallingParticles particles = law_of(column);
  double first = 1e9;
  for (std::size_t i = 0; i < 20; ++i)
    first = std::min(first, fall_time(column.height[i], column.velocity[i], column.gravity));
  column.fly(first * 0.99);
  EXPECT_EQ(column.impulse, 0);
  EXPECT_NEAR(column.mean(column.height), falling_height(particles, first * 0.99), 1e-14);
  EXPECT_NEAR(column.mean(column.velocity), falling_velocity(particles, first * 0.99), 1e-14);
}

TEST(FallingParticles, FloorTakesMomentumAndEnergy) {
  Column column = some_column();
  const FallingParticles particles = law_of(column);
  const auto kinetic = [&] {
    double sum = 0;
    for (double velocity : column.velocity) sum += 1.3 * velocity * velocity / 2;
    return sum / 20;
  };
  const double before = kinetic();
  for (double time = 0.5; time < 4; time += 0.5) {
    column.fly(0.5);
    EXPECT_NEAR(floor_impulse(particles, time, column.mean(column.velocity)), column.impulse, 1e-11);
    EXPECT_NEAR(collapse_loss(particles, column.mean(column.height), before) - kinetic(), column.lost / 20,
                1e-12);
  }
}

TEST(FallTime, IsWhenTheParticleArrives) {
  for (double velocity : {-3.0, 0.0, 2.0}) {
    const double time = fall_time(1.7, velocity, 2);
    EXPECT_NEAR(falling_height({.gravity = 2, .height = 1.7, .velocity = velocity}, time), 0, 1e-14);
    EXPECT_GT(time, 0);
  }
  EXPECT_NEAR(fall_time(1e-9, -1e3, 1), 1e-12, 1e-24);
}

TEST(PackedHeight, IsThatOfRowsOfTouchingSquaresOrCubes) {
  constexpr double square = 0.78539816339744831, cube = 0.52359877559829887;
  EXPECT_NEAR(packed_height({.dimension = 2, .diameter = 0.1, .fraction = square}, 100, 2), 0.25, 1e-14);
  EXPECT_NEAR(packed_height({.dimension = 3, .diameter = 0.1, .fraction = cube}, 2000, 4), 0.25, 1e-14);
}

}  // namespace
}  // namespace sandglass::law::falling_test
