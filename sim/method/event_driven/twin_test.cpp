#include "sim/method/event_driven/test_twin.hpp"

namespace sandglass::event_driven::twin_test {
namespace {

TEST(Twin, DiluteAndDenseDisks) {
  expect_same_events(lattice_gas<2>(10, 5), 80);
  expect_same_events(lattice_gas<2>(10, 1.3), 400);
  expect_same_events(triangular_gas(10, 10, 0.7), 400);
}

TEST(Twin, DiluteAndDenseSpheres) {
  expect_same_events(lattice_gas<3>(4, 4), 50);
  expect_same_events(lattice_gas<3>(4, 1.2), 200);
  expect_same_events(cubic_gas(3, 0.5), 150);
}

TEST(Twin, InelasticDisksAndSpheres) {
  auto disks = lattice_gas<2>(10, 1.5);
  disks.set_restitution(0.8);
  expect_same_events(disks, 400);
  auto spheres = lattice_gas<3>(4, 1.4);
  spheres.set_restitution(0.8);
  expect_same_events(spheres, 150);
}

TEST(Twin, RestitutionThatDependsOnTheVelocity) {
  auto disks = lattice_gas<2>(10, 1.5);
  disks.parameters.surfaces.front().normal = {0.6, 1.5};
  expect_same_events(disks, 300);
}

TEST(Twin, MixturesOfTwoKinds) {
  auto disks = lattice_gas<2>(10, 1.6);
  disks.make_mixture(0.4, 0.1);
  disks.set_restitution(0.9);
  expect_same_events(disks, 150);
  auto spheres = lattice_gas<3>(4, 1.5);
  spheres.make_mixture(0.3, 0.05);
  expect_same_events(spheres, 100);
}

TEST(Twin, RoughParticlesThatSlideOrStick) {
  auto disks = lattice_gas<2>(10, 1.5);
  disks.set_restitution(0.9);
  disks.make_rough(0.4, 0.2);
  expect_same_events(disks, 300);
  auto spheres = lattice_gas<3>(4, 1.4);
  spheres.set_restitution(0.9);
  spheres.make_rough(0, 0.3);
  expect_same_events(spheres, 150);
}

TEST(Twin, CollisionsThatTheContactTimeModelMakesElastic) {
  auto disks = triangular_gas(10, 10, 0.6);
  disks.set_restitution(0.7);
  disks.parameters.contact_time = 0.1;
  expect_same_events(disks, 300);
  const auto engine = disks.make();
  engine->step(1, 0);
  const double guarded = engine->counters().at("guarded-collisions");
  EXPECT_GT(guarded, 20);
  EXPECT_LT(guarded, static_cast<double>(engine->tally().collisions));
}

TEST(Twin, GravityBetweenWallsAndAlongAPeriodicAxis) {
  for (const double sideways : {0.0, 0.7}) {
    auto disks = lattice_gas<2>(10, 1.6);
    disks.parameters.gravity = {sideways, -0.5};
    disks.add_walls(1);
    expect_same_events(disks, 300);
  }
  auto spheres = lattice_gas<3>(4, 1.6);
  spheres.parameters.gravity = {0, 0.2, -0.5};
  spheres.add_walls(0);
  spheres.add_walls(2);
  expect_same_events(spheres, 200);
}

TEST(Twin, ObstacleAndWalls) {
  TestGas<2> gas = lattice_gas<2>(10, 1.6);
  auto& phases = gas.particles.phases;
  const Vector<2> centre(8, 8);
  std::erase_if(phases, [&](const Phase<2>& phase) { return (phase.position - centre).norm() < 3.2; });
  gas.parameters.particles = phases.size();
  gas.add_walls(1);
  gas.add_obstacle(centre, 2.5);
  AllPairs<2> twin(gas);
  twin.add_obstacle(centre, 2.5);
  expect_same_events(gas, twin, 300);
}

/// Few particles: the cells are large, and the nearest image of a particle need not be the one that will be hit.
TEST(Twin, AFewParticlesInALargeBox) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    expect_same_events(lattice_gas<2>(2, 3, true, seed), 8);
    expect_same_events(lattice_gas<3>(2, 2.5, true, seed), 12);
    expect_same_events(lattice_gas<2>(3, 2, true, seed), 20);
  }
}

TEST(Twin, TheSmallestBoxIsFourDiameters) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    expect_same_events(lattice_gas<2>(3, 4.0 / 3, true, seed), 30);
    expect_same_events(lattice_gas<3>(3, 4.0 / 3, true, seed), 60);
  }
}

TEST(Twin, WalledBoxesOfOneCell) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    auto narrow = lattice_gas<2>(1, 1.9, true, seed);
    narrow.parameters.geometry.box = {8, 1.9};
    narrow.add({3, 0.7}, {-0.4, 0.3});
    narrow.add({6, 1.1}, {0.2, -0.5});
    narrow.add_walls(1);
    expect_same_events(narrow, 30);
    auto closed = narrow;
    closed.agents.clear();
    closed.add_walls(0);
    closed.add_walls(1);
    expect_same_events(closed, 30);
  }
}

}  // namespace
}  // namespace sandglass::event_driven::twin_test
