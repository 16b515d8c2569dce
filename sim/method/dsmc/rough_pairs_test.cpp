#include "sim/method/dsmc/test_cells.hpp"
#include "sim/physics/collision.hpp"

#include <gtest/gtest.h>

// Particles with spin in the collision kernel; the rule itself is tested in sim/physics.

namespace sandglass::dsmc::rough_pairs_test {
namespace {

Parameters rough(int dimension, const Surface& surface) {
  Parameters parameters;
  const double inertia =
      dimension == 2 ? 1.0 / 8 : 1.0 / 10;  // full disk and sphere of diameter and mass one
  parameters.kinds = {{{1, 1, inertia}}, {surface}, true, {}};
  parameters.cross_section = cross_section(dimension, 1);
  parameters.restitution = surface.normal.value;
  return parameters;
}

template <int D>
TestCells<D> spinning(std::size_t count) {
  TestCells<D> cells;
  cells.add_cell(random_velocities<D>(count, 5));
  Random random(StreamKey(2, Purpose::spins, 0, 0), 0);
  for (std::size_t i = 0; i < count; ++i) {
    Spin<D> spin;
    for (double& component : spin.reshaped()) component = 4 * random.uniform() - 2;
    cells.spins.push_back(spin);
  }
  return cells;
}

template <int D>
struct Sums {
  Vector<D> momentum = Vector<D>::Zero();
  double translation = 0, rotation = 0;
};

template <int D>
Sums<D> sums(const TestCells<D>& cells, double inertia) {
  Sums<D> all;
  for (std::size_t i = 0; i < cells.particles.size(); ++i) {
    all.momentum += cells.particles[i].velocity;
    all.translation += 0.5 * cells.particles[i].velocity.squaredNorm();
    all.rotation += 0.5 * inertia * cells.spins[i].squaredNorm();
  }
  return all;
}

template <int D>
Sums<D> after(const Surface& surface, TestCells<D> cells) {
  const Parameters parameters = rough(D, surface);
  const auto stage = make_collision_stage<D>(parameters);
  for (std::uint64_t step = 0; step < 40; ++step) cells.collide(*stage, 0.01, step);
  EXPECT_GT(cells.tally.collisions, 50u);
  return sums(cells, parameters.kinds.species.front().inertia);
}

template <int D>
void expect_conservation() {
  const auto cells = spinning<D>(20);
  const double inertia = rough(D, {}).kinds.species.front().inertia;
  const Sums<D> before = sums(cells, inertia);
  const auto total = [](const Sums<D>& all) { return all.translation + all.rotation; };
  const Sums<D> perfectly = after<D>({{1}, 1}, cells), smooth = after<D>({{1}, -1}, cells),
                fully = after<D>({{1}, 0}, cells), sliding = after<D>({{1}, 1, 0.1}, cells);
  for (const Sums<D>& all : {perfectly, smooth, fully, sliding})
    EXPECT_NEAR((all.momentum - before.momentum).norm(), 0, 1e-12);
  EXPECT_NEAR(total(perfectly), total(before), 1e-12 * total(before));
  EXPECT_GT(std::abs(perfectly.rotation - before.rotation), 0.01 * before.rotation);
  EXPECT_NEAR(smooth.translation, before.translation, 1e-12 * before.translation);
  EXPECT_EQ(smooth.rotation, before.rotation);
  EXPECT_LT(total(fully), 0.99 * total(before));
  EXPECT_LT(total(sliding), total(before));
  EXPECT_GT(total(sliding), total(fully));
}

TEST(RoughPairs, KeepWhatTheirSurfaceKeeps) {
  expect_conservation<2>();
  expect_conservation<3>();
}

/// Spins do not enter the rate. Transparent particles: it stays what it is.
TEST(RoughPairs, CollideAsOftenAsSmoothOnes) {
  const auto velocities = random_velocities<3>(6, 0);
  Parameters parameters = rough(3, {{-1}, -1});
  const auto stage = make_collision_stage<3>(parameters);
  double collisions = 0;
  constexpr std::uint64_t kStreams = 40'000;
  for (std::uint64_t stream = 0; stream < kStreams; ++stream) {
    TestCells<3> cells;
    cells.add_cell(velocities);
    cells.spins.assign(6, Spin<3>::Zero());
    cells.collide(*stage, 1.7 / candidates_per_coefficient(velocities), stream);
    collisions += static_cast<double>(cells.tally.collisions) / kStreams;
  }
  const double expected = 1.7 / candidates_per_coefficient(velocities) * 2 *
                          sum_pairs(velocities, [](double speed) { return speed; });
  EXPECT_NEAR(collisions, expected, 4.5 * std::sqrt(1.7 / kStreams));  // a Poisson number at most
}

/// The planted fault: the change of spin has the other sign, velocities do not show it.
TEST(RoughPairs, FaultReversesTheChangeOfSpin) {
  Parameters parameters = rough(2, {{1}, 0.5});
  const auto honest = make_faulty_collision_stage<2>(parameters);
  parameters.faults.spins_reversed = true;
  const auto faulty = make_faulty_collision_stage<2>(parameters);
  for (std::uint64_t stream = 0; stream < 20; ++stream) {
    auto one = spinning<2>(2), two = one;
    const auto before = one.spins;
    one.collide(*honest, 0.4, stream);
    two.collide(*faulty, 0.4, stream);
    if (one.tally.collisions != 1) continue;
    EXPECT_EQ(one.particles[0].velocity, two.particles[0].velocity);
    EXPECT_NEAR((one.spins[0] - before[0] + two.spins[0] - before[0]).norm(), 0, 1e-14);
    EXPECT_NE(one.spins[1], before[1]);
  }
}

/// What an offset carries goes along the line of centres, friction or not.
TEST(RoughPairs, SayTheMomentumChangeAlongTheLineOfCentres) {
  Parameters parameters = rough(3, {{1}, 0});
  parameters.offset.consistent = 1;
  parameters.measure_transfer = true;
  const auto stage = make_collision_stage<3>(parameters);
  for (std::uint64_t stream = 0; stream < 50; ++stream) {
    auto cells = spinning<3>(2);
    const Vector<3> before = cells.particles[0].velocity - cells.particles[1].velocity;
    cells.collide(*stage, 0.3, stream);
    if (cells.tally.collisions != 1) continue;
    const Vector<3> normal = cells.particles[0].position;
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
    const Vector<3> now = cells.particles[0].velocity - cells.particles[1].velocity;
    EXPECT_NEAR(now.dot(normal), -before.dot(normal), 1e-12);  // elastic along the normal alone
    EXPECT_NEAR(cells.tally.transfer.value(), now.dot(normal), 1e-12);
  }
}

}  // namespace
}  // namespace sandglass::dsmc::rough_pairs_test
