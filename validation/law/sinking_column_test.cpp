#include "validation/law/sinking_column.hpp"

#include "validation/law/sedimentation.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::sinking_column_test {
namespace {

SinkingColumn column_of(int dimension, double freedom, double mean_free_paths) {
  Gas gas{.dimension = dimension, .diameter = 0.01, .mass = 1.3, .temperature = 0.65};
  const double area = dimension == 2 ? 2 * gas.diameter : std::numbers::pi * gas.diameter * gas.diameter;
  gas.fraction = mean_free_paths / 10 / (std::numbers::sqrt2 * area) * particle_volume(gas);
  return {gas, 0.1, 10, freedom};
}

double height_at_rest(const SinkingColumn& column) {
  const MixedColumn all{{{column.gas.mass, 1, column.height}}, column.gravity, column.freedom};
  const double end = sedimentation_temperature(all, even_column_energy(all, column.gas.temperature));
  return mean_column_height({column.gas.mass, end, column.gravity, column.height});
}

/// The equations keep energy and weight without knowing of the law: what is left in the end is its profile.
TEST(SinkingColumn, EndsInEquilibrium) {
  for (const auto& [dimension, freedom] : {std::pair{2, 2.0}, {3, 3.0}, {3, 6.0}}) {
    const SinkingColumn column = column_of(dimension, freedom, 10);
    const Fall fall = fall_of_column(column, 150, 25);
    EXPECT_NEAR(fall.height.front(), 5, 1e-12);
    EXPECT_NEAR(fall.height.back() / height_at_rest(column), 1, 1.0 / (25 * 25)) << freedom;
  }
}

TEST(SinkingColumn, ConvergesWithTheSquareOfTheParts) {
  const SinkingColumn column = column_of(2, 2, 10);
  const auto end = [&](int cells) { return fall_of_column(column, 11, cells).height.back(); };
  const double coarse = end(10), middle = end(20), fine = end(40);
  EXPECT_NEAR((coarse - middle) / (middle - fine), 4, 0.8);
  EXPECT_LT(std::abs(middle - fine), 1e-2);
}

/// Weak gravity, short mean free path: half a period of the slowest sound wave. Without conduction the gas swings about a place
/// that is 1/gamma of the way to its rest, and turns as far beyond it: depth 2/gamma - 1.
TEST(SinkingColumn, SwingsAsSoundInADenseGas) {
  SinkingColumn column = column_of(3, 3, 500);
  column.gravity = 1e-3;
  const Column sound{column.gas.mass, column.gas.temperature, column.gravity, column.height};
  const Bounce bounce = first_bounce(column);
  EXPECT_NEAR(bounce.time * column_sound_frequency(sound, 3) / std::numbers::pi, 1, 0.01);
  EXPECT_NEAR(bounce.depth, 2 / (5 / 3.0) - 1, 0.01);
}

TEST(SinkingColumn, StaysWithoutWeight) {
  SinkingColumn still = column_of(2, 2, 10);
  still.gravity = 0;
  EXPECT_NEAR(fall_of_column(still, 5, 10).height.back(), 5, 1e-12);
}

}  // namespace
}  // namespace sandglass::law::sinking_column_test
