#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_cells.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Each planted fault changes what it says, by as much as it says. Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::faults_test {
namespace {

constexpr std::uint64_t kStreams = 100'000;

Parameters with(const Faults& faults) {
  Parameters parameters;
  parameters.faults = faults;
  return parameters;
}

/// `chance(speed / diagonal)`: what becomes of the acceptance |v_ij| / bound, per honest candidate.
template <class Chance>
void expect_rate(const Faults& faults, double candidates, Chance chance) {
  const auto velocities = random_velocities<2>(6, 0);
  Parameters parameters = with(faults);
  parameters.restitution = -1;  // transparent: the rate stays what it is
  const double per_coefficient = candidates_per_coefficient(velocities), diagonal = per_coefficient / 30;
  const auto counts = count_collisions(*make_faulty_collision_stage<2>(parameters), velocities,
                                       candidates / per_coefficient, kStreams);
  const double expected =
      candidates * sum_pairs(velocities, [&](double speed) { return chance(speed / diagonal); }) / 15;
  const Mean mean = mean_of_independent(counts);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
}

TEST(Faults, NoneKeepsTheRate) {
  expect_rate({}, 1.7, [](double part) { return part; });
}

TEST(Faults, LowBoundCutsOffFastPairs) {
  expect_rate({.bound = 0.5}, 1.7, [](double part) { return std::min(part, 0.5); });
}

TEST(Faults, InvertedAcceptanceTakesTheOthers) {
  expect_rate({.acceptance_inverted = true}, 1.7, [](double part) { return 1 - part; });
}

TEST(Faults, TruncatedFractionLosesCandidates) {
  expect_rate({.fraction_truncated = true}, 1.7, [](double part) { return part / 1.7; });
  expect_rate({.fraction_truncated = true}, 0.7, [](double) { return 0; });
}

/// Changes of velocity of the first particle of a pair that flies apart along the first axis.
template <int D>
std::vector<double> first_kicks(const Faults& faults) {
  std::vector<double> kicks;
  const std::vector<Vector<D>> velocities{Vector<D>::Unit(0), -Vector<D>::Unit(0)};
  const auto stage = make_faulty_collision_stage<D>(with(faults));
  for (std::uint64_t stream = 0; stream < kStreams; ++stream) {
    TestCells<D> cells;
    cells.add_cell(velocities);
    cells.collide(*stage, 0.5 / candidates_per_coefficient(velocities), stream);
    if (cells.tally.collisions == 1) kicks.push_back(cells.particles[0].velocity[0] - 1);
  }
  return kicks;
}

/// The elastic kick along c = 2 is -c <1 - b^2>; <b^2> = 1/3 on the interval and 1/2 on the disk, times the factor squared.
TEST(Faults, ImpactParametersAreScaled) {
  for (double factor : {1.0, 0.9}) {
    const Mean disks = mean_of_independent(first_kicks<2>({.impact = factor}));
    const Mean spheres = mean_of_independent(first_kicks<3>({.impact = factor}));
    EXPECT_NEAR(disks.value, -2 * (1 - factor * factor / 3), 4.5 * disks.standard_error);
    EXPECT_NEAR(spheres.value, -2 * (1 - factor * factor / 2), 4.5 * spheres.standard_error);
  }
}

TEST(Faults, MomentumLeaksFromTheSecondKick) {
  const auto velocities = random_velocities<3>(2, 0);
  const auto stage = make_faulty_collision_stage<3>(with({.momentum_leak = 1e-3}));
  int collisions = 0;
  for (std::uint64_t stream = 0; stream < 1000; ++stream) {
    TestCells<3> cells;
    cells.add_cell(velocities);
    cells.collide(*stage, 0.9 / candidates_per_coefficient(velocities), stream);
    if (cells.tally.collisions == 0) continue;
    ++collisions;
    const Vector<3> kick_0 = cells.particles[0].velocity - velocities[0];
    const Vector<3> kick_1 = cells.particles[1].velocity - velocities[1];
    const Vector<3> whole = kick_0.norm() > kick_1.norm() ? kick_0 : kick_1;
    EXPECT_NEAR((kick_0 + kick_1 - 1e-3 * whole).norm(), 0, 1e-14);
  }
  EXPECT_GT(collisions, 100);
}

TEST(Faults, AreNoticed) {
  EXPECT_FALSE(Faults{}.any());
  EXPECT_TRUE(Faults{.bound = 0.5}.any());
  EXPECT_TRUE(Faults{.momentum_leak = 1e-6}.any());
  EXPECT_TRUE(Faults{.impact = 0.9}.any());
  EXPECT_TRUE(Faults{.acceptance_inverted = true}.any());
  EXPECT_TRUE(Faults{.fraction_truncated = true}.any());
}

}  // namespace
}  // namespace sandglass::dsmc::faults_test
