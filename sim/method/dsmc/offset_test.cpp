#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_cells.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace sandglass::dsmc::offset_test {
namespace {

constexpr std::uint32_t kPairs = 40'000;
constexpr double kRestitution = 0.8, kMass = 1.5;

/// One pair that collided, seen from its first particle.
template <int D>
struct Collided {
  Vector<D> relative;  ///< velocity before
  Vector<D> normal;    ///< direction of the momentum change
  Vector<D> shift_1, shift_2;
  double transfer;  ///< m v'_1 . shift_1 + m v'_2 . shift_2
};

template <int D>
struct Collisions {
  std::vector<Collided<D>> list;
  double transfer = 0;  ///< as the kernel counts it
};

/// Many cells of two particles with less than one candidate each.
template <int D>
Collisions<D> collide_pairs(const Offset& offset) {
  Parameters parameters;
  parameters.restitution = kRestitution;
  parameters.mass = kMass;
  parameters.offset = offset;
  parameters.measure_transfer = true;
  const auto velocities = random_velocities<D>(2, 0);
  TestCells<D> cells;
  for (std::uint32_t pair = 0; pair < kPairs; ++pair) cells.add_cell(velocities);
  cells.collide(*make_collision_stage<D>(parameters), 0.9 / candidates_per_coefficient(velocities), 0);
  Collisions<D> collisions;
  collisions.transfer = cells.tally.transfer.value();
  for (std::uint32_t pair = 0; pair < kPairs; ++pair) {
    const Phase<D>&one = cells.particles[2 * pair], &two = cells.particles[2 * pair + 1];
    if (one.velocity == velocities[0]) continue;
    collisions.list.push_back({velocities[0] - velocities[1], (one.velocity - velocities[0]).normalized(),
                               one.position, two.position,
                               kMass * (one.velocity.dot(one.position) + two.velocity.dot(two.position))});
  }
  EXPECT_EQ(collisions.list.size(), cells.tally.collisions);
  EXPECT_GT(collisions.list.size(), 10'000u);
  return collisions;
}

template <int D>
void expect_consistent_offset() {
  for (const Collided<D>& pair : collide_pairs<D>({0.7, 0}).list) {
    EXPECT_LT((pair.shift_1 - 0.7 * pair.normal).norm(), 1e-13);
    EXPECT_EQ(pair.shift_2, -pair.shift_1);
  }
}

TEST(ConsistentOffset, IsALengthAlongTheMomentumChange) {
  expect_consistent_offset<2>();
  expect_consistent_offset<3>();
}

/// The direction of the extra offset knows neither an axis nor the normal.
template <int D>
void expect_random_offset() {
  std::vector<std::vector<double>> parts(D + 1);
  for (const Collided<D>& pair : collide_pairs<D>({0.7, 0.3}).list) {
    const Vector<D> extra = pair.shift_1 - 0.7 * pair.normal;
    EXPECT_NEAR(extra.norm(), 0.3, 1e-13);
    EXPECT_EQ(pair.shift_2, -pair.shift_1);
    for (int axis = 0; axis < D; ++axis) parts[static_cast<std::size_t>(axis)].push_back(extra[axis]);
    parts[D].push_back(extra.dot(pair.normal));
  }
  for (const auto& part : parts) {
    const Mean mean = mean_of_independent(part);
    EXPECT_NEAR(mean.value, 0, 4.5 * mean.standard_error);
    EXPECT_NEAR(mean.standard_error * std::sqrt(static_cast<double>(part.size())), 0.3 / std::sqrt(D), 0.01);
  }
}

TEST(RandomOffset, AddsALengthInAnyDirection) {
  expect_random_offset<2>();
  expect_random_offset<3>();
}

template <int D>
void expect_transfer(const Offset& offset) {
  const Collisions<D> collisions = collide_pairs<D>(offset);
  double sum = 0, virial = 0;
  for (const Collided<D>& pair : collisions.list) {
    sum += pair.transfer;
    virial += kMass * offset.consistent * kRestitution * std::abs(pair.relative.dot(pair.normal));
  }
  EXPECT_NEAR(collisions.transfer / sum, 1, 1e-12);
  if (offset.random == 0) {
    EXPECT_NEAR(sum / virial, 1, 1e-12);
  }
}

/// An offset of length l carries m l r |c_n| a collision, c_n the normal relative velocity before.
TEST(Transfer, IsWhatTheOffsetsCarry) {
  expect_transfer<2>({0.7, 0});
  expect_transfer<3>({0.7, 0});
  expect_transfer<2>({0.7, 0.3});
  expect_transfer<3>({0.7, 0.3});
}

TEST(Transfer, IsNotMeasuredUnasked) {
  Parameters parameters;
  parameters.offset.consistent = 1;
  TestCells<2> cells;
  cells.add_cell(random_velocities<2>(6, 0));
  cells.collide(*make_collision_stage<2>(parameters), 1, 0);
  EXPECT_GT(cells.tally.collisions, 0u);
  EXPECT_EQ(cells.tally.transfer.value(), 0);
}

TEST(NoOffset, LeavesPositionsAlone) {
  TestCells<3> cells;
  cells.add_cell(random_velocities<3>(6, 0));
  cells.collide(*make_collision_stage<3>({}), 1, 0);
  EXPECT_GT(cells.tally.collisions, 0u);
  for (const Phase<3>& particle : cells.particles) EXPECT_EQ(particle.position, Vector<3>(0, 0, 0));
}

}  // namespace
}  // namespace sandglass::dsmc::offset_test
