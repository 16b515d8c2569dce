#include "sim/method/dsmc/pair_rule.hpp"

#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/collision_kernel.hpp"
#include "sim/method/dsmc/test_cells.hpp"

#include <gtest/gtest.h>

// The kernel with another pair rule than its own: disks of two diameters and masses. Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::pair_rule_test {
namespace {

/// Diameter and mass are one plus position[0], which is 0 or 1. Cross-sections in units of that of two small disks.
class TwoSizes : public PairRule<2> {
 public:
  struct Columns {
    Phase<2>* phases;
    double size(std::uint32_t particle) const { return 1 + phases[particle].position[0]; }
  };
  explicit TwoSizes(const Parameters& parameters) : restitution_(parameters.restitution) {}

  Columns columns(const CollisionStep<2>& step, std::uint32_t cell) const {
    return {step.particles + step.offsets[cell]};
  }
  double bound(const Columns&, std::uint32_t, double speed) const { return 2 * speed; }  // two large disks
  bool accepts(const Columns& columns, const Pair& pair, double square_speed, double square_bound,
               double uniform) const {
    const double width = 0.5 * (columns.size(pair.first) + columns.size(pair.second));
    return uniform * uniform * square_bound < square_speed * width * width;
  }
  Vector<2> collide(const Columns& columns, const Pair& pair, const Vector<2>& relative, double square_speed,
                    Random& random) const {
    const double mass_1 = columns.size(pair.first), mass_2 = columns.size(pair.second);
    const Vector<2> kick = 2 * smooth_kick(relative, square_speed, restitution_, random) / (mass_1 + mass_2);
    columns.phases[pair.first].velocity += mass_2 * kick;
    columns.phases[pair.second].velocity -= mass_1 * kick;
    return mass_2 * kick;
  }
  double rate(const Columns&, const Pair&, double speed) const { return speed; }
  double transfer(const Columns&, const Pair&, const Vector<2>&) const { return 0; }

 private:
  double restitution_;
};

TestCells<2> mixture(const std::vector<Vector<2>>& velocities) {
  TestCells<2> cells;
  cells.add_cell(velocities);
  for (std::size_t i = 0; i < cells.particles.size(); ++i)
    cells.particles[i].position[0] = static_cast<double>(i % 2);
  return cells;
}

TEST(PairRule, SetsHowOftenAPairCollides) {
  const auto velocities = random_velocities<2>(6, 0);
  const double coefficient = 0.7 / candidates_per_coefficient(velocities);
  const CollisionKernel<2, TwoSizes, false> kernel(transparent());
  std::vector<double> counts;
  for (std::uint64_t stream = 0; stream < 200'000; ++stream) {
    TestCells<2> cells = mixture(velocities);
    cells.collide(kernel, coefficient, stream);
    counts.push_back(static_cast<double>(cells.tally.collisions));
  }
  double expected = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      expected += 2 * coefficient * (velocities[i] - velocities[j]).norm() *
                  (1 + 0.5 * (static_cast<double>(i % 2) + static_cast<double>(j % 2)));
  const Mean mean = mean_of_independent(counts);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
}

TEST(PairRule, SetsWhatACollisionDoes) {
  TestCells<2> cells = mixture(random_velocities<2>(9, 0));
  const auto sums = [&] {
    Vector<3> sum = Vector<3>::Zero();  // momentum, energy
    for (const Phase<2>& particle : cells.particles) {
      const double mass = 1 + particle.position[0];
      sum +=
          mass * Vector<3>(particle.velocity[0], particle.velocity[1], 0.5 * particle.velocity.squaredNorm());
    }
    return sum;
  };
  const Vector<3> before = sums();
  cells.collide(CollisionKernel<2, TwoSizes, false>({}), 3, 0);
  EXPECT_GT(cells.tally.collisions, 100u);
  EXPECT_LT((sums() - before).norm(), 1e-12);
}

}  // namespace
}  // namespace sandglass::dsmc::pair_rule_test
