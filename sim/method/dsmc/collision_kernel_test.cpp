#include "sim/method/dsmc/test_cells.hpp"

#include <cstring>

#include <gtest/gtest.h>

// What every collision must keep, and that the answer cannot depend on how cells are shared out.

namespace sandglass::dsmc::collision_kernel_test {
namespace {

template <int D>
TestCells<D> crowd(std::uint32_t count) {
  TestCells<D> cells;
  for (std::uint32_t cell = 0; cell < count; ++cell)
    cells.add_cell(random_velocities<D>(cell * 7 % 13, cell));
  return cells;
}

template <int D>
struct Sums {
  Vector<D> momentum = Vector<D>::Zero();
  double energy = 0;
};

template <int D>
Sums<D> sums(const TestCells<D>& cells, std::uint32_t cell) {
  Sums<D> sums;
  for (std::uint32_t i = cells.offsets[cell]; i < cells.offsets[cell + 1]; ++i) {
    sums.momentum += cells.particles[i].velocity;
    sums.energy += cells.particles[i].velocity.squaredNorm();
  }
  return sums;
}

template <int D>
void expect_conservation(double restitution) {
  Parameters parameters;
  parameters.restitution = restitution;
  const TestCells<D> before = crowd<D>(300);
  TestCells<D> after = crowd<D>(300);
  after.collide(*make_collision_stage<D>(parameters), 3, 0);
  ASSERT_GT(after.tally.collisions, 8000u);
  for (std::uint32_t cell = 0; cell < before.size(); ++cell) {
    const Sums<D> was = sums(before, cell), is = sums(after, cell);
    EXPECT_LT((is.momentum - was.momentum).norm(), 1e-13);
    if (restitution == 1) {
      EXPECT_NEAR(is.energy, was.energy, 1e-12);
    } else {
      EXPECT_LE(is.energy, was.energy);
    }
  }
}

TEST(Collisions, ConserveMomentumAndElasticEnergyInEachCell) {
  expect_conservation<2>(1);
  expect_conservation<3>(1);
  expect_conservation<2>(0.6);
  expect_conservation<3>(0.6);
}

Parameters with_everything() {
  Parameters parameters;
  parameters.restitution = 0.9;
  parameters.factor.formula = henderson;
  parameters.offset = {1, 0.5};
  parameters.measure_transfer = true;
  return parameters;
}

template <int D>
void expect_same(const TestCells<D>& a, const TestCells<D>& b) {
  EXPECT_EQ(std::memcmp(a.particles.data(), b.particles.data(), a.particles.size() * sizeof(Phase<D>)), 0);
  EXPECT_EQ(a.tally.collisions, b.tally.collisions);
  EXPECT_EQ(a.tally.candidates, b.tally.candidates);
  EXPECT_EQ(a.bound_raised, b.bound_raised);
  EXPECT_EQ(a.tally.transfer.value(), b.tally.transfer.value());
}

template <int D>
void expect_independence_of_cuts(const Parameters& parameters) {
  const auto stage = make_collision_stage<D>(parameters);
  TestCells<D> whole = crowd<D>(300), pieces = whole, backwards = whole;
  const std::vector<double> factor(300, 1.3);
  stage->collide(whole.step(0.1, 5, factor.data()), 0, 300);
  std::uint32_t first = 0;
  for (std::uint32_t last : {1u, 1u, 7u, 70u, 134u, 299u, 300u}) {
    stage->collide(pieces.step(0.1, 5, factor.data()), first, last);
    first = last;
  }
  for (std::uint32_t cell = 300; cell-- > 0;)
    stage->collide(backwards.step(0.1, 5, factor.data()), cell, cell + 1);
  ASSERT_GT(whole.tally.collisions, 1000u);
  expect_same(whole, pieces);
  expect_same(whole, backwards);
}

TEST(Collisions, DoNotDependOnHowCellsAreSharedOut) {
  expect_independence_of_cuts<2>({});
  expect_independence_of_cuts<3>({});
  expect_independence_of_cuts<2>(with_everything());
  expect_independence_of_cuts<3>(with_everything());
}

TEST(Collisions, StepAndCellNameTheStream) {
  const auto stage = make_collision_stage<3>({});
  const auto velocities = random_velocities<3>(6, 1);
  TestCells<3> cells, later;
  for (int copy = 0; copy < 2; ++copy) cells.add_cell(velocities);
  later.add_cell(velocities);
  cells.collide(*stage, 10, 0);
  later.collide(*stage, 10, 1);
  EXPECT_NE(cells.particles[0].velocity, cells.particles[6].velocity);
  EXPECT_NE(cells.particles[0].velocity, later.particles[0].velocity);
}

}  // namespace
}  // namespace sandglass::dsmc::collision_kernel_test
