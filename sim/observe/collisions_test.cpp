#include "sim/observe/collisions.hpp"

#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::collisions_test {
namespace {

/// Two particles at +-speed along x: temperature mass (2 speed^2 + 0) / (2 - 1) / 2 on the mean over two axes.
TestSystem<2> pair(double speed) {
  TestSystem<2> system;
  system.add_cell({{{0, 0}, {speed, 0}}, {{1, 0}, {-speed, 0}}});
  return system;
}

/// weight N T / V with weight 3, N = 2, T = 2 speed^2, V = 16.
double kinetic(double speed) { return 3 * 2 * 2 * speed * speed / 16; }

TEST(Pressure, IsTheMeanOverTheInterval) {
  auto system = pair(1);
  Pressure<2> pressure;
  system.tally.transfer.add(100);  // carried before the run
  pressure.start(system.view());
  system.particles = pair(2).particles;
  system.tally.transfer.add(8);
  system.time = 0.5;
  const auto first = pressure.measure(system.view());
  EXPECT_DOUBLE_EQ(first[0], std::sqrt(kinetic(1) * kinetic(2)));
  EXPECT_DOUBLE_EQ(first[1], 3 * 8 / (2 * 16 * 0.5));
  EXPECT_DOUBLE_EQ(first[2], first[0] + first[1]);
  system.time = 2.5;
  const auto second = pressure.measure(system.view());
  EXPECT_DOUBLE_EQ(second[0], kinetic(2));
  EXPECT_DOUBLE_EQ(second[1], 0);
  EXPECT_FALSE(pressure.measures_at_start());
}

TEST(Pressure, GoesOnFromItsState) {
  auto system = pair(1);
  system.tally.transfer.add(1.0 / 3);
  Pressure<2> whole, resumed;
  whole.start(system.view());
  resumed.load(whole.save());
  system.particles = pair(3).particles;
  system.tally.transfer.add(1e-9);
  system.time = 1;
  EXPECT_EQ(whole.measure(system.view()), resumed.measure(system.view()));
}

/// Haff's law T = (1 + t)^-2: the mean over an interval is the geometric mean of its ends.
TEST(Pressure, GeometricMeanIsExactUnderHaffsLaw) {
  const auto speed = [](double t) { return 1 / (1 + t); };
  Pressure<2> pressure;
  auto system = pair(speed(1));
  system.time = 1;
  pressure.start(system.view());
  system.particles = pair(speed(4)).particles;
  system.time = 4;
  const double mean = kinetic(1) * (1 / 2.0 - 1 / 5.0) / 3;  // integral of (1 + t)^-2 from 1 to 4
  EXPECT_NEAR(pressure.measure(system.view())[0], mean, 1e-14);
}

TEST(CollisionCount, TellsCollisionsOrCandidates) {
  auto system = pair(1);
  system.tally.collisions = 7;
  system.tally.candidates = 11;
  EXPECT_EQ(CollisionCount<2>(false).measure(system.view())[0], 7);
  EXPECT_EQ(CollisionCount<2>(true).measure(system.view())[0], 11);
  EXPECT_TRUE(CollisionCount<2>(false).cumulative());
}

TEST(Plane, OuterBinsTakeWhatLiesBeyond) {
  Plane plane(0, 1, {-2, -1, 0, 3});
  for (double v : {-50.0, -2.0, -1.5, -1.0, -1e-300, 1e-300, 2.9, 3.0, 1e9}) plane.count(v);
  EXPECT_EQ(plane.up(), 4);
  EXPECT_EQ(plane.down(), 5);
  EXPECT_EQ(plane.take_histogram(), (std::vector<double>{3, 2, 4}));
}

TEST(Plane, HistogramIsSinceTheLastCallAndCountsSinceTimeZero) {
  Plane plane(0, 1, {-1, 0, 1});
  plane.count(0.5);
  EXPECT_EQ(plane.take_histogram(), (std::vector<double>{0, 1}));
  plane.count(-0.5);
  EXPECT_EQ(plane.take_histogram(), (std::vector<double>{1, 0}));
  EXPECT_EQ(plane.up() + plane.down(), 2);
}

TEST(Plane, GoesOnFromItsState) {
  Plane plane(0, 1, {-1, 0, 1}), resumed = plane;
  for (double v : {0.5, 0.6, -0.1}) plane.count(v);
  resumed.load(plane.save());
  EXPECT_EQ(resumed.up(), 2);
  EXPECT_EQ(resumed.down(), 1);
  EXPECT_EQ(resumed.take_histogram(), (std::vector<double>{1, 2}));
}

TEST(Crossings, SeeTheirOwnPlane) {
  TestSystem<2> system;
  ObserverSpec spec;
  spec.bins = 2;
  for (int i = 0; i < 2; ++i) system.planes.emplace_back(0, i, bin_edges(spec));
  system.planes[1].count(1);
  system.planes[1].count(-1);
  system.planes[1].count(-2);
  EXPECT_EQ(Crossings<2>(spec, 1).measure(system.view()), (std::vector<double>{2, 1}));
  EXPECT_EQ(CrossingCount<2>(1).measure(system.view()), (std::vector<double>{1, 2}));
  EXPECT_EQ(Crossings<2>(spec, 0).measure(system.view()), (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace sandglass::collisions_test
