#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/collision_kernel.hpp"
#include "sim/method/dsmc/test_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

// The bound on relative speeds, and what happens when collisions raise it within a step.

namespace sandglass::dsmc::bound_test {
namespace {

template <int D>
void expect_box_of_velocities() {
  for (std::uint32_t count = 1; count <= 30; ++count) {
    const auto velocities = random_velocities<D>(count, count);
    TestCells<D> cells;
    cells.add_cell(velocities);
    VelocityBox<D> box(cells.particles.data(), count);
    const double diagonal = count == 1 ? 0 : candidates_per_coefficient(velocities) / (count * (count - 1.0));
    EXPECT_NEAR(std::sqrt(box.square_diagonal()), diagonal, 1e-14);
    sum_pairs(velocities, [&](double speed) {
      EXPECT_LE(speed, std::sqrt(box.square_diagonal()) * (1 + 1e-15));
      return 0;
    });
    const Vector<D> outlier = Vector<D>::Constant(-7);
    box.include(Lanes<D>::from(outlier, 0));
    for (const Vector<D>& velocity : velocities)
      EXPECT_LE((velocity - outlier).squaredNorm(), box.square_diagonal());
  }
}

TEST(VelocityBox, BoundsEveryRelativeSpeed) {
  expect_box_of_velocities<2>();
  expect_box_of_velocities<3>();
}

/// The slow twin, Kac's process: pair ij waits an exponential time of mean 1/(2 coefficient |v_ij|) for its collision.
template <int D>
double collisions_of_kac_process(std::vector<Vector<D>> velocities, double coefficient, Random& random) {
  int collisions = 0;
  for (double time = 0;; ++collisions) {
    const double rate = 2 * coefficient * sum_pairs(velocities, [](double speed) { return speed; });
    time -= std::log(1 - random.uniform()) / rate;
    if (time > 1) return collisions;
    double left = rate * random.uniform();
    for (std::size_t i = 0; i < velocities.size() && left >= 0; ++i)
      for (std::size_t j = 0; j < i && left >= 0; ++j) {
        const Vector<D> relative = velocities[i] - velocities[j];
        left -= 2 * coefficient * relative.norm();
        if (left >= 0) continue;
        SmoothInelastic{1}(velocities[i], velocities[j],
                           contact_normal(relative, 1 / relative.norm(), uniform_impact<D>(random)));
      }
  }
}

/// One fast particle among slow ones: its energy spreads in every direction, which widens the box again and again. The
/// steps are long enough for the mean rate to settle: until then a fixed number of candidates, where Kac's process has a
/// Poisson number, differs by half the change of the rate per candidate.
template <int D>
void expect_rate_of_kac_process(double coefficient, std::uint64_t streams) {
  auto velocities = random_velocities<D>(12, 0);
  for (Vector<D>& velocity : velocities) velocity *= 0.01;
  velocities[0] = 10 * Vector<D>::Unit(0);
  const auto stage = make_collision_stage<D>({});
  const Mean fast = mean_of_independent(count_collisions(*stage, velocities, coefficient, streams));
  Random random(StreamKey(2, Purpose::collisions, 0, 0), 0);
  std::vector<double> counts(streams);
  for (double& count : counts) count = collisions_of_kac_process(velocities, coefficient, random);
  const Mean slow = mean_of_independent(counts);
  EXPECT_NEAR(fast.value, slow.value, 4.5 * std::hypot(fast.standard_error, slow.standard_error)) << D << "D";
  EXPECT_LT(slow.standard_error, 0.002 * slow.value);
}

TEST(Bound, RaisedWithinAStepKeepsTheRate) {
  expect_rate_of_kac_process<2>(0.05, 40'000);
  expect_rate_of_kac_process<3>(0.05, 40'000);
  expect_rate_of_kac_process<2>(0.2, 10'000);
  expect_rate_of_kac_process<3>(0.2, 10'000);
}

TEST(Bound, IsRaisedByTheFastParticle) {
  auto velocities = random_velocities<2>(12, 0);
  for (Vector<2>& velocity : velocities) velocity *= 0.01;
  velocities[0] = {10, 0};
  TestCells<2> cells;
  cells.add_cell(velocities);
  cells.collide(*make_collision_stage<2>({}), 0.05, 0);
  EXPECT_GT(cells.bound_raised, 0u);
}

/// In equilibrium the mean rate stays what it is at the start, whatever happens to the bound.
TEST(Bound, EquilibriumKeepsItsRateThroughAStep) {
  const auto stage = make_collision_stage<3>({});
  constexpr double kCoefficient = 0.2;
  std::vector<double> excess, rate;
  TestCells<3> cells;
  cells.add_cell(random_velocities<3>(6, 1));
  for (std::uint64_t stream = 0; stream < 1000; ++stream) cells.collide(*stage, kCoefficient, stream);
  for (std::uint64_t stream = 1000; stream < 101'000; ++stream) {
    std::vector<Vector<3>> velocities;
    for (const Phase<3>& particle : cells.particles) velocities.push_back(particle.velocity);
    const std::uint64_t before = cells.tally.collisions;
    cells.collide(*stage, kCoefficient, stream);
    const double expected = 2 * kCoefficient * sum_pairs(velocities, [](double speed) { return speed; });
    excess.push_back(static_cast<double>(cells.tally.collisions - before) - expected);
    rate.push_back(expected);
  }
  const Mean mean = mean_of_correlated(excess);
  EXPECT_GT(cells.bound_raised, 10'000u);
  EXPECT_NEAR(mean.value, 0, 4.5 * mean.standard_error);
  EXPECT_LT(mean.standard_error, 0.003 * mean_of_correlated(rate).value);
}

/// Speeds for which a step would take hours end the run with a reason.
TEST(Bound, RefusesMoreCandidatesThanAStepCanTake) {
  const auto stage = make_collision_stage<2>({});
  for (const double speed : {1e12, 1e200, std::numeric_limits<double>::infinity()}) {
    TestCells<2> cells;
    cells.add_cell({{0, 0}, {speed, 0}, {0, 1}});
    EXPECT_THROW(cells.collide(*stage, 0.05, 0), RunError) << speed;
  }
}

/// The box around the velocities keeps a NaN of the first particle and passes over that of a later one, which then
/// collides with nobody. The next motion refuses it (MotionStage.StopsAtWhatIsNotANumber).
TEST(Bound, NoNumberKeepsACellBusyOrSpreads) {
  const auto stage = make_collision_stage<2>({});
  for (const std::size_t place : {0u, 1u, 2u}) {
    TestCells<2> cells;
    std::vector<Vector<2>> velocities{{0, 0}, {1, 0}, {0, 1}};
    velocities[place].x() = std::nan("");
    cells.add_cell(velocities);
    if (place == 0) {
      EXPECT_THROW(cells.collide(*stage, 0.05, 0), RunError);
    } else {
      for (std::uint64_t stream = 0; stream < 100; ++stream) cells.collide(*stage, 0.05, stream);
      EXPECT_LT(cells.tally.candidates, 1000u);
    }
    const auto broken = [](const Phase<2>& particle) { return !particle.velocity.allFinite(); };
    EXPECT_EQ(std::ranges::count_if(cells.particles, broken), 1) << place;
  }
}

}  // namespace
}  // namespace sandglass::dsmc::bound_test
