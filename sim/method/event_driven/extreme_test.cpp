#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven::extreme_test {
namespace {

TEST(Extreme, NobodyAndOneAndAllAtRest) {
  const auto nobody = TestGas<2>({10, 10}).make();
  nobody->step(1e6, 0);
  EXPECT_EQ(nobody->view().particles.size(), 0u);

  TestGas<3> alone({10, 10, 10});
  alone.add({1, 2, 3}, {0.5, -0.25, 0});
  const auto one = alone.make();
  one->step(1e4, 0);
  EXPECT_LT((one->view().particles[0].position - Vector<3>(1, 2, 3)).norm(), 1e-9);
  EXPECT_EQ(one->tally().collisions, 0u);

  auto still = lattice_gas<2>(5, 1.5);
  for (auto& phase : still.particles.phases) phase.velocity.setZero();
  const auto rest = still.make();
  rest->step(1e9, 0);
  EXPECT_EQ(by_id(*rest)[7].position, still.particles.phases[7].position);
}

/// The same gas at any speed: times scale with its inverse, collisions do not know it.
TEST(Extreme, SpeedsOfAnySize) {
  std::uint64_t expected = 0;
  for (const double speed : {1.0, 1e-150, 1e-100, 1e100, 1e150}) {
    SCOPED_TRACE(speed);
    auto gas = triangular_gas(10, 10, 0.5);
    for (auto& phase : gas.particles.phases) phase.velocity *= speed;
    const auto engine = gas.make();
    for (int i = 0; i < 10; ++i) engine->step(0.1 / speed, 0);
    if (expected == 0) expected = engine->tally().collisions;
    EXPECT_GT(expected, 100u);
    EXPECT_NEAR(static_cast<double>(engine->tally().collisions), static_cast<double>(expected), 2);
    EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
    EXPECT_NEAR(kinetic_energy(*engine) / speed / speed, kinetic_energy(*triangular_gas(10, 10, 0.5).make()),
                1e-10);
  }
}

TEST(Extreme, MassesFromOneToAMillionAndDiametersFromOneToTwenty) {
  TestGas<2> gas({100, 100});
  gas.parameters.species = {{20, 1e6, 0}, {1, 1, 0}};
  gas.parameters.surfaces.assign(4, {});
  const auto velocities = thermal_velocities<2>(400);
  for (int i = 0; i < 4; ++i) {
    gas.add({25.0 + 50 * (i % 2), 25.0 + 50 * (i / 2)}, 1e-3 * velocities[static_cast<std::size_t>(i)]);
    gas.particles.columns.append(column::species, 0);
  }
  for (int i = 0; i < 400; ++i) {
    const Vector<2> place(5 * (i % 20) + 0.5, 5 * (i / 20) + 0.5);
    bool free = true;
    for (int k = 0; k < 4; ++k)
      free &= (place - gas.particles.phases[static_cast<std::size_t>(k)].position).norm() > 11;
    if (!free) continue;
    gas.add(place, velocities[static_cast<std::size_t>(i)]);
    gas.particles.columns.append(column::species, 1);
  }
  const auto engine = gas.make();
  const auto energy = [&] {
    const auto view = engine->view();
    double sum = 0;
    for (std::size_t i = 0; i < view.particles.size(); ++i)
      sum +=
          view.traits[view.columns.get(column::species)[i]].mass * view.particles[i].velocity.squaredNorm();
    return sum;
  };
  const double before = energy();
  engine->step(300, 0);
  EXPECT_GT(engine->tally().collisions, 1000u);
  EXPECT_NEAR(energy() / before, 1, 1e-11);
  EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
}

/// A row of balls, touching or nearly so: the last flies away with the speed of the first (equal masses, r = 1).
TEST(Extreme, NewtonsCradle) {
  for (const double spacing : {0.0, 1e-15, 1e-9, 1e-3}) {
    SCOPED_TRACE(spacing);
    TestGas<2> gas({40, 10});
    gas.add({5, 5}, {1, 0});
    for (int i = 0; i < 5; ++i) gas.add({10 + i * (1 + spacing), 5}, {0, 0});
    const auto engine = gas.make();
    engine->step(10, 0);
    const auto phases = by_id(*engine);
    EXPECT_EQ(engine->tally().collisions, 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(phases[i].velocity[0], 0, 1e-14) << i;
    EXPECT_NEAR(phases[5].velocity[0], 1, 1e-14);
    EXPECT_NEAR(phases[5].position[0], 14 + 10 - 4, 1e-2);
  }
}

/// Every disk touches its neighbours: many contacts at one instant, none a collapse.
TEST(Extreme, ATouchingLattice) {
  for (const double speed : {1.0, 1e-150, 1e100}) {
    SCOPED_TRACE(speed);
    TestGas<2> gas({17, 9});  // with room at two sides: the lattice can open
    const auto velocities = thermal_velocities<2>(16 * 8);
    for (int i = 0; i < 16 * 8; ++i)
      gas.add({i % 16 + 0.5, i / 16 + 0.5}, speed * velocities[static_cast<std::size_t>(i)]);
    const auto engine = gas.make();
    const double before = kinetic_energy(*engine);
    EXPECT_NO_THROW(engine->step(5 / speed, 0));
    EXPECT_GT(engine->tally().collisions, 300u);
    EXPECT_NEAR(kinetic_energy(*engine) / before, 1, 1e-12);
    EXPECT_LT(engine->tally().deepest_overlap, 1e-12);
  }
}

TEST(Extreme, AnOverlapThatGrowsIsAContactAndOneThatShrinksIsNone) {
  for (const double sign : {-1.0, 1.0}) {
    TestGas<2> gas({10, 10});
    gas.add({5, 5}, {-sign, 0});
    gas.add({5.9, 5}, {sign, 0});
    const auto engine = gas.make();
    engine->step(0.5, 0);
    EXPECT_EQ(engine->tally().collisions, sign > 0 ? 0u : 1u);
    EXPECT_EQ(by_id(*engine)[0].velocity[0], -1);
    EXPECT_NEAR(engine->tally().deepest_overlap, sign > 0 ? 0 : 0.1, 1e-15);
  }
}

/// Passing by at just the contact distance, and a few digits to either side: a contact or none, but an end.
TEST(Extreme, GrazingToRounding) {
  for (int digits = -20; digits <= 20; ++digits)
    for (const double angle : {0.0, 0.1, 0.7853981633974483, 1.3}) {
      const double offset = 1 + digits * 1.1e-16;
      const Vector<2> along(std::cos(angle), std::sin(angle)), across(-along[1], along[0]);
      TestGas<2> gas({20, 20});
      gas.add({10, 10}, {0.3, -0.1});
      gas.add(Vector<2>(10, 10) + offset * across - 3 * along, along + Vector<2>(0.3, -0.1));
      const auto engine = gas.make();
      ASSERT_NO_THROW(engine->step(6, 0)) << digits << ' ' << angle;
      EXPECT_LE(engine->tally().collisions, 3u);
      EXPECT_LT(engine->tally().deepest_overlap, 1e-14);
      EXPECT_LT((by_id(*engine)[1].velocity - along - Vector<2>(0.3, -0.1)).norm(), 1e-6);
    }
}

/// Half a box apart two images are equally near: the one ahead is hit.
TEST(Extreme, MeetingAcrossTheBoundaryFromHalfABoxAway) {
  for (const double length : {4.0, 4.3, 5.1, 7.0, 12.0})
    for (const double sign : {-1.0, 1.0}) {
      TestGas<2> gas({length, 8});
      gas.add({length / 4, 2}, {sign, 0});
      gas.add({length * 3 / 4, 2}, {-sign, 0});
      const auto engine = gas.make();
      engine->step((length / 2 - 1) / 2 + 0.3, 0);
      EXPECT_EQ(engine->tally().collisions, 1u) << length << ' ' << sign;
      EXPECT_LT(engine->tally().deepest_overlap, 1e-14);
    }
}

/// An arc that turns just at the edge of a cell must not lose its cell: whoever comes by hits it.
TEST(Extreme, ABallThatTurnsAtTheEdgeOfACell) {
  for (const double edge : {2.0, 4.0, 6.0}) {
    TestGas<2> gas({12, 12});
    gas.parameters.gravity = {0, -1};
    gas.add_walls(1);
    gas.add({3, edge}, {0, 0});
    const double period = 2 * std::sqrt(2 * (edge - 0.5));
    const auto engine = gas.make();
    for (int i = 1; i <= 200; ++i) {
      engine->step(period, 0);
      ASSERT_NEAR(engine->view().particles[0].position[1], edge, 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace sandglass::event_driven::extreme_test
