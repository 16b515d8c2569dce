#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::conservation_test {
namespace {

/// A long elastic run: momentum and energy to rounding, and nobody inside anybody.
template <int D>
void expect_conserved(const TestGas<D>& gas, std::uint64_t collisions) {
  const auto engine = gas.make();
  const double energy = kinetic_energy(*engine);
  const double count = static_cast<double>(engine->view().particles.size());
  while (engine->tally().collisions < collisions) {
    engine->step(2, 0);
    ASSERT_GE(smallest_gap(*engine, gas.parameters.geometry), -1e-12) << engine->tally().collisions;
  }
  // Contacts stand at a distance of 1 to the last digits, where rounding has a direction: a last digit a collision.
  const double rounding = 2.2e-16 * 2 * static_cast<double>(collisions) / count;
  EXPECT_NEAR(kinetic_energy(*engine) / energy, 1, rounding);
  EXPECT_LT(momentum(*engine).norm(), 1e-11);
  EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
}

TEST(Conservation, AMillionCollisionsOfDenseDisks) { expect_conserved(triangular_gas(10, 12, 0.7), 1000000); }
TEST(Conservation, DenseSpheres) { expect_conserved(cubic_gas(3, 0.5), 200000); }
TEST(Conservation, DiluteDisks) { expect_conserved(lattice_gas<2>(6, 12), 20000); }
TEST(Conservation, TheSmallestBox) {
  expect_conserved(lattice_gas<2>(3, 4.0 / 3), 100000);
  expect_conserved(lattice_gas<3>(3, 4.0 / 3), 100000);
}
TEST(Conservation, LongBoxes) {
  TestGas<2> flat({40, 4});
  TestGas<3> needle({4, 4, 30});
  const auto velocities = thermal_velocities<2>(60);
  for (int i = 0; i < 60; ++i)
    flat.add({(i % 20 + 0.5) * 2, (i / 20 + 0.5) * 1.3}, velocities[static_cast<std::size_t>(i)]);
  const auto others = thermal_velocities<3>(60);
  for (int i = 0; i < 60; ++i)
    needle.add({(i % 2 + 0.5) * 2, (i / 2 % 2 + 0.5) * 2, (i / 4 + 0.5) * 2},
               others[static_cast<std::size_t>(i)]);
  expect_conserved(flat, 50000);
  expect_conserved(needle, 50000);
}

/// Gravity between elastic walls: what rises loses what it gains in height.
TEST(Conservation, EnergyUnderGravity) {
  auto gas = lattice_gas<2>(8, 1.5);
  gas.parameters.gravity = {0.3, -1};
  gas.add_walls(0);
  gas.add_walls(1);
  const auto total = [&](Simulator<2>& engine) {
    double sum = kinetic_energy(engine);
    for (const auto& phase : engine.view().particles) sum -= gas.parameters.gravity.dot(phase.position);
    return sum;
  };
  const auto engine = gas.make();
  const double before = total(*engine);
  while (engine->tally().collisions < 100000) engine->step(2, 0);
  EXPECT_NEAR(total(*engine), before, 1e-10 * std::fabs(before));
  EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
  EXPECT_GE(smallest_gap(*engine, gas.parameters.geometry), -1e-12);
  for (const auto& phase : engine->view().particles)
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_GE(phase.position[axis], 0.5 - 1e-12);
      EXPECT_LE(phase.position[axis], 12 - 0.5 + 1e-12);
    }
}

TEST(Conservation, RoughParticlesKeepMomentumAndPerfectlyRoughOnesEnergy) {
  auto gas = triangular_gas(8, 8, 0.5);
  gas.make_rough(1, std::numeric_limits<double>::infinity());
  const auto engine = gas.make();
  const double inertia = gas.parameters.species.front().inertia, before = kinetic_energy(*engine);
  engine->step(200, 0);
  double spinning = 0;
  for (const auto& spin : engine->view().columns.get(column::spin<2>))
    spinning += 0.5 * inertia * spin.squaredNorm();
  EXPECT_GT(engine->tally().collisions, 10000u);
  EXPECT_GT(spinning, 0.2 * before);
  EXPECT_NEAR(kinetic_energy(*engine) + spinning, before, 1e-11 * before);
  EXPECT_LT(momentum(*engine).norm(), 1e-11);
}

TEST(Conservation, MixturesKeepMomentumAndEnergy) {
  auto gas = lattice_gas<3>(4, 1.3);
  gas.make_mixture(0.1, 0.001);
  const auto engine = gas.make();
  const auto sums = [&] {
    const auto view = engine->view();
    Vector<4> sum = Vector<4>::Zero();
    for (std::size_t i = 0; i < view.particles.size(); ++i) {
      const Vector<3>& v = view.particles[i].velocity;
      sum[3] += view.traits[view.columns.get(column::species)[i]].mass * v.squaredNorm() / 2;
      sum.head<3>() += view.traits[view.columns.get(column::species)[i]].mass * v;
    }
    return sum;
  };
  const Vector<4> before = sums();
  engine->step(100, 0);
  EXPECT_GT(engine->tally().collisions, 1000u);
  EXPECT_LT((sums() - before).norm(), 1e-11);
  EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
}

/// Eight decades of energy (Haff): the row of the calendar goes along. A collision costs as many searches and as much
/// storage at the end as at the beginning.
TEST(Cooling, TheCalendarFollowsEightDecadesOfEnergy) {
  auto gas = triangular_gas(8, 8, 0.2);
  gas.set_restitution(0.9);
  const auto engine = gas.make();
  const double energy = kinetic_energy(*engine);
  double dt = 1, first_cost = 0, last_cost = 0, mark = 1e-1, searched = 0;
  std::uint64_t collisions = 0;
  std::size_t bytes = 0;
  while (mark > 1e-9) {
    engine->step(dt, 0);
    if (engine->tally().collisions < collisions + 200) dt *= 1.5;
    const double now = kinetic_energy(*engine) / energy;
    if (now > mark) continue;
    const auto counters = engine->counters();
    const double searches = counters.at("predictions") + counters.at("cell-crossings");
    last_cost = (searches - searched) / static_cast<double>(engine->tally().collisions - collisions);
    if (first_cost == 0) first_cost = last_cost, bytes = engine->bytes();
    collisions = engine->tally().collisions, searched = searches;
    mark = now / 10;
    EXPECT_LT(last_cost, 3 * first_cost) << "at " << now;
    EXPECT_LT(engine->bytes(), 2 * bytes) << "at " << now;
  }
  EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
}

}  // namespace
}  // namespace sandglass::event_driven::conservation_test
