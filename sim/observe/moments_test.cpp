#include "sim/base/error.hpp"
#include "sim/base/random.hpp"
#include "sim/observe/collisions.hpp"
#include "sim/observe/distribution.hpp"
#include "sim/observe/energy.hpp"
#include "sim/observe/test_view.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Energy, temperature, momentum and velocity moments against small systems worked by hand.

namespace sandglass::moments_test {
namespace {

/// Mean velocity (2, 1); relative velocities (1, 2), (-3, 0), (1, -1), (1, -1). Mass 2, weight 3.
TestSystem<2> four() {
  TestSystem<2> system;
  system.add_cell({{{0, 0}, {3, 3}}, {{1, 0}, {-1, 1}}});
  system.add_cell({});
  system.add_cell({{{2, 0}, {3, 0}}, {{3, 0}, {3, 0}}});
  return system;
}

TEST(Energy, CountsEveryRealParticle) {
  auto system = four();
  EXPECT_DOUBLE_EQ(Energy<2>().measure(system.view())[0], 0.5 * 3 * 2 * (18 + 2 + 9 + 9));
}

TEST(Temperature, HasThreeDegreesOfFreedomForFourParticles) {
  auto system = four();
  const auto values = Temperature<2>().measure(system.view());
  EXPECT_DOUBLE_EQ(values[0], 2 * (1 + 9 + 1 + 1) / 3.0);
  EXPECT_DOUBLE_EQ(values[1], 2 * (4 + 0 + 1 + 1) / 3.0);
  EXPECT_DOUBLE_EQ(values[2], (values[0] + values[1]) / 2);
}

TEST(Momentum, IsTheSumOfAllAndItsScaleThatOfTheirLengths) {
  auto system = four();
  const auto momentum = Momentum<2>().measure(system.view());
  EXPECT_DOUBLE_EQ(momentum[0], 3 * 2 * 8);
  EXPECT_DOUBLE_EQ(momentum[1], 3 * 2 * 4);
  EXPECT_DOUBLE_EQ(MomentumScale<2>().measure(system.view())[0], 6 * (std::sqrt(18) + std::sqrt(2) + 3 + 3));
}

/// x: squares 1, 9, 1, 1; y: 4, 0, 1, 1; speed: 5, 9, 2, 2.
TEST(Moments, AreRelativeToTheSecond) {
  auto system = four();
  const auto values = Moments<2>().measure(system.view());
  ASSERT_EQ(values.size(), 7u);
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_DOUBLE_EQ(values[1], ((1 + 81 + 1 + 1) / 4.0 / 9 + (16 + 0 + 1 + 1) / 4.0 / 2.25) / 2);
  EXPECT_DOUBLE_EQ(values[2], ((3 + 729) / 4.0 / 27 + (2 + 64) / 4.0 / 3.375) / 2);
  EXPECT_DOUBLE_EQ(values[3], ((3 + 6561) / 4.0 / 81 + (2 + 256) / 4.0 / 5.0625) / 2);
  EXPECT_DOUBLE_EQ(values[4], (25 + 81 + 4 + 4) / 4.0 / 20.25);
  EXPECT_DOUBLE_EQ(values[5], (125 + 729 + 8 + 8) / 4.0 / 91.125);
  EXPECT_DOUBLE_EQ(values[6], (625 + 6561 + 16 + 16) / 4.0 / 410.0625);
}

/// Velocities (+-1, 0, 0), (0, +-1, 0), (0, 0, +-1): m4 = (2/6) / (2/6)^2 = 3 and s4 = 1.
TEST(Moments, OfAnOctahedron) {
  TestSystem<3> system;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0}) system.add_cell({{Vector<3>::Zero(), sign * Vector<3>::Unit(axis)}});
  const auto values = Moments<3>().measure(system.view());
  EXPECT_DOUBLE_EQ(values[1], 3);
  EXPECT_DOUBLE_EQ(values[2], 9);
  EXPECT_DOUBLE_EQ(values[3], 27);
  for (std::size_t i = 4; i < 7; ++i) EXPECT_DOUBLE_EQ(values[i], 1);
}

TEST(OneParticle, HasNoTemperatureAndNoMoments) {
  auto system = random_system<2>(Vector<2>::Constant(4), 1, 9);
  EXPECT_EQ(Temperature<2>().measure(system.view()), (std::vector<double>{0, 0, 0}));
  Pressure<2> pressure;
  pressure.start(system.view());
  system.time = 1;
  EXPECT_EQ(pressure.measure(system.view())[2], 0);
  EXPECT_THROW(Moments<2>().start(system.view()), InputError);
}

TEST(Moments, AlongALineAreRefused) {
  TestSystem<2> system;
  system.add_cell({{{1, 1}, {1, 0}}, {{1, 1}, {-1, 0}}});
  EXPECT_THROW(Moments<2>().measure(system.view()), RunError);
}

TEST(VelocityHistogram, OuterBinsTakeWhatLiesBeyond) {
  ObserverSpec spec;
  spec.axis = 1;
  spec.range = {-1, 1};
  spec.bins = 4;
  TestSystem<2> system;
  for (double v : {-7.0, -1.0, -0.5, -0.1, 0.0, 0.49, 0.5, 1.0, 1e30}) system.add_cell({{{0, 0}, {9, v}}});
  EXPECT_EQ(VelocityHistogram<2>(spec).measure(system.view()), (std::vector<double>{2, 2, 2, 3}));
}

TEST(ShearMode, IsTheAmplitudeOfTheWave) {
  TestSystem<2> system;
  for (int i = 0; i < 64; ++i) {
    const double y = system.box[1] * i / 64, phase = 2 * M_PI * 3 * y / system.box[1];
    system.add_cell({{{0, y}, {0.7 * std::sin(phase) - 0.2 * std::cos(phase) + 5, 1}}});
  }
  EXPECT_NEAR(ShearMode<2>(3, false).measure(system.view())[0], 0.7, 1e-14);
  EXPECT_NEAR(ShearMode<2>(3, true).measure(system.view())[0], -0.2, 1e-14);
  EXPECT_NEAR(ShearMode<2>(2, false).measure(system.view())[0], 0, 1e-14);
}

/// The same cells in another order, with velocities over twelve decades: not a bit may change.
TEST(Sums, DoNotDependOnTheOrderOfCells) {
  Random random(StreamKey(6, Purpose::velocities, 0, 0), 0);
  std::vector<std::vector<Phase<3>>> cells(50);
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    for (std::size_t i = 0; i < cell % 7; ++i) {
      const double scale = std::pow(10, 12 * random.uniform() - 6);
      cells[cell].push_back(
          {4 * Vector<3>(random.uniform(), random.uniform(), random.uniform()),
           scale * (Vector<3>(random.uniform(), random.uniform(), random.uniform()).array() - 0.5)});
    }
  TestSystem<3> forwards, backwards;
  for (const auto& cell : cells) forwards.add_cell(cell);
  std::ranges::reverse(cells);
  for (const auto& cell : cells) backwards.add_cell(cell);
  const auto expect_same = [&](Observer<3>&& observer) {
    EXPECT_EQ(observer.measure(forwards.view()), observer.measure(backwards.view()))
        << observer.quantity().name;
  };
  expect_same(Energy<3>());
  expect_same(Temperature<3>());
  expect_same(Momentum<3>());
  expect_same(MomentumScale<3>());
  expect_same(Moments<3>());
  expect_same(ShearMode<3>(2, false));
  expect_same(VelocityHistogram<3>({}));
}

}  // namespace
}  // namespace sandglass::moments_test
