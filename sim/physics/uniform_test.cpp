#include "sim/base/statistics.hpp"
#include "sim/physics/collision.hpp"

#include <vector>

#include <gtest/gtest.h>

// Random points of a circle, a sphere and a cross-section: moments that a uniform distribution must have, within 4.5
// standard errors.

namespace sandglass::uniform_test {
namespace {

constexpr int kDraws = 400'000;

template <class Draw, class Function>
void expect_mean(Draw draw, Function function, double expected, const char* what) {
  Random random(StreamKey(5, Purpose::collisions, 0, 0), 0);
  std::vector<double> samples(kDraws);
  for (double& sample : samples) sample = function(draw(random));
  const Mean mean = mean_of_independent(samples);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error) << what;
}

template <int D>
void expect_uniform_direction(double fourth, double cross) {
  const auto draw = [](Random& random) { return uniform_direction<D>(random); };
  for (int axis = 0; axis < D; ++axis) {
    const int next = (axis + 1) % D;
    expect_mean(
        draw, [=](const Vector<D>& e) { return e[axis]; }, 0, "mean");
    expect_mean(
        draw, [=](const Vector<D>& e) { return e[axis] * e[axis]; }, 1.0 / D, "square");
    expect_mean(
        draw, [=](const Vector<D>& e) { return e[axis] * e[next]; }, 0, "product");
    expect_mean(
        draw, [=](const Vector<D>& e) { return std::pow(e[axis], 4); }, fourth, "fourth power");
    expect_mean(
        draw, [=](const Vector<D>& e) { return std::pow(e[axis] * e[next], 2); }, cross, "squares");
  }
}

/// <e_i^4> = 3/(D (D + 2)), <e_i^2 e_j^2> = 1/(D (D + 2)).
TEST(UniformDirection, HasTheMomentsOfACircleAndOfASphere) {
  expect_uniform_direction<2>(3.0 / 8, 1.0 / 8);
  expect_uniform_direction<3>(3.0 / 15, 1.0 / 15);
}

TEST(UniformDirection, HasUnitLength) {
  Random random(StreamKey(6, Purpose::collisions, 0, 0), 0);
  for (int i = 0; i < 10000; ++i) {
    EXPECT_NEAR(uniform_direction<2>(random).norm(), 1, 1e-14);
    EXPECT_NEAR(uniform_direction<3>(random).norm(), 1, 1e-14);
  }
}

TEST(UniformImpact, FillsTheInterval) {
  const auto draw = [](Random& random) { return uniform_impact<2>(random)[0]; };
  expect_mean(
      draw, [](double b) { return b; }, 0, "mean");
  expect_mean(
      draw, [](double b) { return b * b; }, 1.0 / 3, "square");
  expect_mean(
      draw, [](double b) { return std::pow(b, 4); }, 1.0 / 5, "fourth power");
  expect_mean(
      draw, [](double b) { return std::abs(b) <= 1; }, 1, "inside");
}

TEST(UniformImpact, FillsTheDisk) {
  const auto draw = [](Random& random) { return uniform_impact<3>(random); };
  expect_mean(
      draw, [](const Vector<2>& b) { return b[0]; }, 0, "x");
  expect_mean(
      draw, [](const Vector<2>& b) { return b[1]; }, 0, "y");
  expect_mean(
      draw, [](const Vector<2>& b) { return b[0] * b[1]; }, 0, "x y");
  expect_mean(
      draw, [](const Vector<2>& b) { return b[0] * b[0]; }, 1.0 / 4, "x^2");
  expect_mean(
      draw, [](const Vector<2>& b) { return b.squaredNorm(); }, 1.0 / 2, "r^2");
  expect_mean(
      draw, [](const Vector<2>& b) { return std::pow(b.squaredNorm(), 2); }, 1.0 / 3, "r^4");
  expect_mean(
      draw, [](const Vector<2>& b) { return b.squaredNorm() < 1; }, 1, "inside");
}

}  // namespace
}  // namespace sandglass::uniform_test
