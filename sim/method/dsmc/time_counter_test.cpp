#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/dsmc/test_cells.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Collisions by the clock of each cell. Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::time_counter_test {
namespace {

Parameters with_clocks(Parameters parameters = transparent()) {
  parameters.pair_count = PairCount::time_counter;
  return parameters;
}

/// Collisions of one cell whose velocities stay what they are, in each of `steps` steps.
template <int D>
std::vector<double> collisions_by_step(const CollisionStage<D>& stage, TestCells<D>& cells,
                                       double coefficient, std::uint64_t steps) {
  std::vector<double> counts;
  cells.clocks.assign(cells.size(), 0.5);
  for (std::uint64_t step = 0; step < steps; ++step) {
    const std::uint64_t before = cells.tally.collisions;
    cells.collide(stage, coefficient, step);
    counts.push_back(static_cast<double>(cells.tally.collisions - before));
  }
  return counts;
}

/// In the long run, whatever the mean time between collisions is in steps.
template <int D>
void expect_rate_of_kinetic_theory(double collisions) {
  TestCells<D> cells;
  const auto velocities = random_velocities<D>(7, 0);
  cells.add_cell(velocities);
  const double sum = sum_pairs(velocities, [](double speed) { return speed; });
  const auto stage = make_collision_stage<D>(with_clocks());
  const Mean mean = mean_of_correlated(collisions_by_step(*stage, cells, collisions / (2 * sum), 200'000));
  EXPECT_NEAR(mean.value, collisions, 4.5 * mean.standard_error) << collisions << " in " << D << "D";
  EXPECT_LT(mean.standard_error, 0.02 * collisions);
}

TEST(TimeCounter, CollidesAtTheRateOfKineticTheory) {
  for (double collisions : {0.03, 0.7, 3.4}) {
    expect_rate_of_kinetic_theory<2>(collisions);
    expect_rate_of_kinetic_theory<3>(collisions);
  }
}

/// One pair takes the same time for every collision.
TEST(TimeCounter, OnePairCollidesLikeAClock) {
  TestCells<3> cells;
  cells.add_cell({{1, 0, 0}, {-1, 0, 0}});
  const auto stage = make_collision_stage<3>(with_clocks());
  constexpr double kRate = 0.37;
  const auto counts = collisions_by_step(*stage, cells, kRate / 4, 1000);
  double sum = 0;
  for (std::size_t step = 0; step < counts.size(); ++step) {
    sum += counts[step];
    ASSERT_NEAR(sum, (static_cast<double>(step) + 1) * kRate, 1);
  }
}

TEST(TimeCounter, ContactFactorMultipliesTheRateOfItsCell) {
  TestCells<2> cells;
  cells.add_cell({{1, 0}, {-1, 0}});
  cells.clocks = {0};
  const auto stage = make_collision_stage<2>(with_clocks());
  const double factor = 1.7;
  for (std::uint64_t step = 0; step < 1000; ++step) stage->collide(cells.step(0.37 / 4, step, &factor), 0, 1);
  EXPECT_NEAR(static_cast<double>(cells.tally.collisions), 1000 * 0.37 * 1.7, 1);
}

/// Species of different width: each pair at its own rate.
TEST(TimeCounter, SpeciesCollideAtTheRateOfTheirCrossSection) {
  Parameters parameters = with_clocks();
  parameters.kinds = {{{1, 1}, {3, 1}}, std::vector<Surface>(4, Surface{{-1}}), false, {}};
  const auto stage = make_collision_stage<2>(parameters);
  TestCells<2> cells;
  const auto velocities = random_velocities<2>(6, 1);
  cells.add_cell(velocities);
  cells.species = {0, 1, 0, 1, 0, 0};
  cells.tally.by_species.assign(4, 0);
  constexpr double kCoefficient = 0.02;
  constexpr std::uint64_t kSteps = 400'000;
  collisions_by_step(*stage, cells, kCoefficient, kSteps);
  for (std::uint8_t kind : {0, 1}) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (cells.species[i] == kind && cells.species[j] == kind)
          sum += (velocities[i] - velocities[j]).norm() * (kind == 0 ? 1.0 / 3 : 1);
    const double expected = 2 * kCoefficient * sum * static_cast<double>(kSteps);
    EXPECT_NEAR(static_cast<double>(cells.tally.by_species[kind * 3u]), expected, 4.5 * std::sqrt(expected));
  }
}

/// Nobody makes up for time in which a cell had no pair that could collide.
TEST(TimeCounter, ClocksWaitForPairs) {
  TestCells<2> cells;
  cells.add_cell({});
  cells.add_cell({{1, 2}});
  cells.add_cell({{1, 2}, {1, 2}, {1, 2}});
  cells.add_cell({{1, 0}, {-1, 0}});
  cells.clocks = {0.3, 1.2, 0.3, 5};
  make_collision_stage<2>(with_clocks())->collide(cells.step(1, 0), 0, 4);
  EXPECT_EQ(cells.tally.collisions, 0u);
  EXPECT_EQ(cells.clocks, (std::vector<double>{0, 1.2 - 1, 0, 4}));
}

/// Two that lose nearly all of their relative speed: the step ends, and the bound follows.
TEST(TimeCounter, EndsWhereTheCellCoolsDown) {
  Parameters parameters = with_clocks({});
  parameters.restitution = 0;
  TestCells<3> cells;
  cells.add_cell({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}});
  cells.clocks = {0};
  cells.collide(*make_collision_stage<3>(parameters), 1e4, 0);
  EXPECT_GE(cells.clocks[0], 0);
  EXPECT_GT(cells.tally.collisions, 10u);
  EXPECT_LT((cells.particles[0].velocity - cells.particles[1].velocity).norm(), 0.01);
}

TEST(TimeCounter, TooLongAStepIsRefused) {
  TestCells<2> cells;
  cells.add_cell({{1, 0}, {-1, 0}});
  cells.clocks = {0};
  EXPECT_THROW(cells.collide(*make_collision_stage<2>(with_clocks()), 1e7, 0), RunError);
}

TEST(CellClocks, FollowTheLengthOfTheStep) {
  CellClocks clocks(false);
  clocks.start(3, StreamKey(1, Purpose::collisions, 0, 0));
  const std::vector<double> start(clocks.values(), clocks.values() + 3);
  for (double value : start) EXPECT_TRUE(value >= 0 && value < 1);
  clocks.begin_step(0.5);
  EXPECT_EQ(clocks.values()[1], start[1]);
  clocks.begin_step(0.25);
  EXPECT_EQ(clocks.values()[1], 2 * start[1]);
}

template <int D>
Dsmc<D> gas(const Parameters& parameters, std::uint32_t edge) {
  std::array<std::uint32_t, D> cells;
  cells.fill(edge);
  return Dsmc<D>(Grid<D>(Vector<D>::Constant(edge), cells), parameters, {}, {});
}

Particles<2> crowd(std::size_t count, double box) {
  Particles<2> all;
  const auto velocities = random_velocities<2>(count, 0), places = random_velocities<2>(count, 1);
  for (std::size_t i = 0; i < count; ++i)
    all.phases.push_back({(places[i] + Vector<2>::Ones()) * (box / 2), velocities[i]});
  return all;
}

/// Bit for bit, the clocks being part of the state.
TEST(TimeCounter, GoesOnAfterARestart) {
  Parameters parameters = with_clocks({});
  parameters.cross_section = 0.05;
  Dsmc<2> whole = gas<2>(parameters, 8), second = gas<2>(parameters, 8);
  whole.assign(crowd(500, 8));
  std::uint64_t step = 0;
  for (; step < 20; ++step) whole.step(0.1, step);
  Particles<2> middle;
  middle.phases.assign(whole.view().particles.begin(), whole.view().particles.end());
  second.restore(middle, whole.save());
  for (; step < 40; ++step) {
    whole.step(0.05, step);
    second.step(0.05, step);
  }
  EXPECT_GT(whole.tally().collisions, 100u);
  EXPECT_TRUE(std::ranges::equal(whole.view().particles, second.view().particles,
                                 [](const Phase<2>& a, const Phase<2>& b) {
                                   return a.position == b.position && a.velocity == b.velocity;
                                 }));
}

/// Clocks that start anew let every cell with a pair collide in every step.
TEST(TimeCounter, ForgottenClocksCollideAtLeastOnceAStep) {
  Parameters parameters = with_clocks({});
  parameters.cross_section = 1e-6;
  parameters.faults.clocks_forgotten = true;
  Dsmc<2> wrong = gas<2>(parameters, 2);
  wrong.assign(crowd(100, 2));
  for (std::uint64_t step = 0; step < 30; ++step) wrong.step(0.01, step);
  EXPECT_EQ(wrong.tally().collisions, 120u);
}

/// With the time of the pair of the first two particles for all.
TEST(TimeCounter, TimeOfAnotherPairIsThatOfTheFirstTwo) {
  Parameters parameters = with_clocks();
  parameters.faults.time_of_other_pair = true;
  const auto velocities = random_velocities<2>(5, 2);
  TestCells<2> cells;
  cells.add_cell(velocities);
  const double rate = 0.02 * 20 * (velocities[0] - velocities[1]).norm();
  collisions_by_step(*make_faulty_collision_stage<2>(parameters), cells, 0.02, 2000);
  EXPECT_NEAR(static_cast<double>(cells.tally.collisions), 2000 * rate, 1);
}

}  // namespace
}  // namespace sandglass::dsmc::time_counter_test
