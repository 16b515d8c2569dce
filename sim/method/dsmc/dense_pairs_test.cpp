#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_cells.hpp"
#include "sim/physics/collision.hpp"

#include <array>

#include <gtest/gtest.h>

// Species of a dense gas: a contact factor and an offset for each pair. Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::dense_pairs_test {
namespace {

constexpr std::array<double, 4> kShares{0.6, 0.8, 0.8, 1};
constexpr std::array<double, 2> kDiameters{1, 3}, kMasses{1, 5};

template <int D>
Parameters dense(double restitution, bool rough, PairCount pair_count) {
  Parameters parameters;
  parameters.kinds.species = {{kDiameters[0], kMasses[0], 0.1}, {kDiameters[1], kMasses[1], 4}};
  parameters.kinds.surfaces.assign(4, Surface{{restitution}});
  parameters.kinds.rough = rough;
  parameters.cross_section = cross_section(D, kDiameters[1]);
  parameters.factor.formula = contact_formula(D);
  parameters.pair_count = pair_count;
  return parameters;
}

/// Sums over the pairs of each two species of the one cell against collisions in many steps.
template <int D>
void expect_rates(bool rough, PairCount pair_count) {
  constexpr std::uint64_t kSteps = 100'000;
  const auto stage = make_collision_stage<D>(dense<D>(-1, rough, pair_count));  // transparent
  TestCells<D> cells;
  const auto velocities = random_velocities<D>(7, 3);
  cells.add_cell(velocities);
  cells.species = {0, 1, 0, 1, 0, 1, 0};
  cells.contact.assign(kShares.begin(), kShares.end());
  cells.clocks = {0.5};
  if (rough) cells.spins.assign(7, Spin<D>::Zero());
  cells.tally.by_species.assign(4, 0);
  constexpr double kCoefficient = 0.01, kFactor = 1.4;
  std::array<double, 4> expected{};
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t pair = cells.species[i] * 2u + cells.species[j];
      const double width = (kDiameters[cells.species[i]] + kDiameters[cells.species[j]]) / 6;
      expected[pair] += 2 * kCoefficient * kFactor * kShares[pair] * (D == 2 ? width : width * width) *
                        (velocities[i] - velocities[j]).norm() * kSteps;
    }
  for (std::uint64_t step = 0; step < kSteps; ++step)
    stage->collide(cells.step(kCoefficient, step, &kFactor), 0, 1);
  const auto counted = [&](std::size_t pair) { return static_cast<double>(cells.tally.by_species[pair]); };
  EXPECT_NEAR(counted(0), expected[0], 4.5 * std::sqrt(expected[0]));
  EXPECT_NEAR(counted(3), expected[3], 4.5 * std::sqrt(expected[3]));
  EXPECT_NEAR(counted(1) + counted(2), expected[1] + expected[2], 4.5 * std::sqrt(expected[1] + expected[2]));
}

TEST(DensePairs, CollideAtTheRateOfTheirContactFactor) {
  for (PairCount pair_count : {PairCount::counted, PairCount::time_counter})
    for (bool rough : {false, true}) {
      expect_rates<2>(rough, pair_count);
      expect_rates<3>(rough, pair_count);
    }
}

/// Partners are moved apart by twice their mean diameter, their centre of mass stays, and what this carries is the momentum
/// handed over times that diameter, as with hard cores.
template <int D>
void expect_offset_of_hard_cores() {
  Parameters parameters = dense<D>(1, false, PairCount::counted);
  parameters.offset.consistent = 1;
  parameters.kinds.offsets = {1, 2, 2, 3};
  parameters.measure_transfer = true;
  const auto stage = make_collision_stage<D>(parameters);
  const auto velocities = random_velocities<D>(2, 5);
  int collisions = 0;
  for (std::uint64_t step = 0; step < 200; ++step) {
    TestCells<D> cells;
    cells.add_cell(velocities);
    cells.species = {0, 1};
    cells.contact.assign(kShares.begin(), kShares.end());
    cells.collide(*stage, 0.9 / candidates_per_coefficient(velocities), step);
    if (cells.tally.collisions == 0) continue;
    ++collisions;
    const Phase<D>&one = cells.particles[0], &two = cells.particles[1];
    EXPECT_NEAR((one.position - two.position).norm(), 4, 1e-13);
    EXPECT_NEAR((kMasses[0] * one.position + kMasses[1] * two.position).norm(), 0, 1e-13);
    EXPECT_NEAR(cells.tally.transfer.value(), 2 * kMasses[0] * (one.velocity - velocities[0]).norm(), 1e-13);
  }
  EXPECT_GT(collisions, 20);
}

TEST(DensePairs, OffsetCarriesTheMomentumOfHardCores) {
  expect_offset_of_hard_cores<2>();
  expect_offset_of_hard_cores<3>();
}

}  // namespace
}  // namespace sandglass::dsmc::dense_pairs_test
