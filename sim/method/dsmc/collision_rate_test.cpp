#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_cells.hpp"
#include "sim/physics/collision.hpp"

#include <cmath>

#include <gtest/gtest.h>

// How often pairs collide: sum over pairs of |v_ij| sigma dt / V, here 2 coefficient |v_ij|. Statistical bounds are 4.5
// standard errors.

namespace sandglass::dsmc::collision_rate_test {
namespace {

template <int D>
void expect_rate_of_kinetic_theory(double candidates, std::uint64_t streams) {
  const auto velocities = random_velocities<D>(7, 0);
  const double coefficient = candidates / candidates_per_coefficient(velocities);
  const auto stage = make_collision_stage<D>(transparent());
  const Mean mean = mean_of_independent(count_collisions(*stage, velocities, coefficient, streams));
  const double expected = 2 * coefficient * sum_pairs(velocities, [](double speed) { return speed; });
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error) << candidates << " candidates in " << D << "D";
}

TEST(CollisionRate, IsThatOfKineticTheory) {
  for (double candidates : {0.03, 0.7, 1.0, 3.4}) {
    expect_rate_of_kinetic_theory<2>(candidates, 200'000);
    expect_rate_of_kinetic_theory<3>(candidates, 200'000);
  }
  expect_rate_of_kinetic_theory<2>(1000.3, 2000);
  expect_rate_of_kinetic_theory<3>(1000.3, 2000);
}

TEST(CollisionRate, FractionOfACandidateIsOneMoreWithThatProbability) {
  const auto velocities = random_velocities<3>(7, 0);
  const auto stage = make_collision_stage<3>(transparent());
  constexpr int kStreams = 100'000;
  int more = 0;
  for (std::uint64_t stream = 0; stream < kStreams; ++stream) {
    TestCells<3> cells;
    cells.add_cell(velocities);
    cells.collide(*stage, 2.3 / candidates_per_coefficient(velocities), stream);
    ASSERT_TRUE(cells.tally.candidates == 2 || cells.tally.candidates == 3);
    more += cells.tally.candidates == 3;
  }
  EXPECT_NEAR(more / static_cast<double>(kStreams), 0.3, 4.5 * std::sqrt(0.21 / kStreams));
}

TEST(CollisionRate, ContactFactorMultipliesTheRateOfItsCell) {
  const auto velocities = random_velocities<2>(5, 0);
  Parameters parameters = transparent();
  parameters.factor.formula = henderson;
  const auto stage = make_collision_stage<2>(parameters);
  const double factor[] = {1, 1.7};
  const double coefficient = 0.5 / candidates_per_coefficient(velocities);
  std::vector<double> counts;
  for (std::uint64_t stream = 0; stream < 200'000; ++stream) {
    TestCells<2> cells;
    cells.add_cell({});
    cells.add_cell(velocities);
    stage->collide(cells.step(coefficient, stream, factor), 0, 2);
    counts.push_back(static_cast<double>(cells.tally.collisions));
  }
  const Mean mean = mean_of_independent(counts);
  const double expected = 1.7 * 2 * coefficient * sum_pairs(velocities, [](double speed) { return speed; });
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
}

/// At most one candidate a step, so that the two particles whose velocities change are the pair.
template <int D>
void expect_pairs_by_relative_speed() {
  constexpr std::size_t kParticles = 5;
  constexpr double kStreams = 300'000;
  const auto velocities = random_velocities<D>(kParticles, 3);
  const double coefficient = 0.9 / candidates_per_coefficient(velocities);
  const auto stage = make_collision_stage<D>({});
  double count[kParticles][kParticles] = {};
  for (std::uint64_t stream = 0; stream < kStreams; ++stream) {
    TestCells<D> cells;
    cells.add_cell(velocities);
    cells.collide(*stage, coefficient, stream);
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < kParticles; ++i)
      if (cells.particles[i].velocity != velocities[i]) changed.push_back(i);
    if (changed.size() == 2) ++count[changed[1]][changed[0]];
  }
  double chi = 0;
  for (std::size_t i = 0; i < kParticles; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double expected = kStreams * 2 * coefficient * (velocities[i] - velocities[j]).norm();
      chi += (count[i][j] - expected) * (count[i][j] - expected) / expected;
    }
  // Ten pairs: chi-square of ten (nearly, as no pair at all is one more outcome): standard deviation 4.5.
  EXPECT_LT(chi, 10 + 5 * 4.5);
}

TEST(CollisionRate, PairsCollideInProportionToTheirRelativeSpeed) {
  expect_pairs_by_relative_speed<2>();
  expect_pairs_by_relative_speed<3>();
}

TEST(CollisionRate, NothingHappensWithoutARelativeMotion) {
  TestCells<3> cells;
  cells.add_cell({});
  cells.add_cell({Vector<3>(1, 2, 3)});
  cells.add_cell(std::vector<Vector<3>>(20, Vector<3>(1, 2, 3)));
  cells.collide(*make_collision_stage<3>({}), 1e6, 0);
  EXPECT_EQ(cells.tally.candidates, 0u);
  for (const Phase<3>& particle : cells.particles) EXPECT_EQ(particle.velocity, Vector<3>(1, 2, 3));
}

/// Two alike and a third: the pair of equal velocities never collides, and nothing divides by its speed.
TEST(CollisionRate, EqualVelocitiesNeverCollide) {
  const std::vector<Vector<2>> velocities{{1, 1}, {1, 1}, {-1, 0}};
  for (std::uint64_t stream = 0; stream < 20'000; ++stream) {
    TestCells<2> cells;
    cells.add_cell(velocities);
    cells.collide(*make_collision_stage<2>({}), 0.9 / candidates_per_coefficient(velocities), stream);
    if (cells.tally.collisions == 1) {
      EXPECT_NE(cells.particles[2].velocity, velocities[2]);
    }
    for (const Phase<2>& particle : cells.particles) ASSERT_TRUE(particle.velocity.allFinite());
  }
}

/// The last cells may be empty; what lies in memory behind the particles must not count.
TEST(CollisionRate, EmptyCellIgnoresTheMemoryBehindIt) {
  for (double garbage : {std::nan(""), HUGE_VAL, 1e300}) {
    TestCells<3> cells;
    cells.add_cell(random_velocities<3>(4, 0));
    cells.add_cell({});
    cells.particles.push_back({Vector<3>::Constant(garbage), Vector<3>::Constant(garbage)});
    cells.particles.push_back({Vector<3>::Constant(garbage), Vector<3>::Constant(-garbage)});
    make_collision_stage<3>({})->collide(cells.step(1, 0), 1, 2);
    EXPECT_EQ(cells.tally.candidates, 0u) << garbage;
  }
}

}  // namespace
}  // namespace sandglass::dsmc::collision_rate_test
