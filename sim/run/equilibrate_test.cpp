#include "sim/run/equilibrate.hpp"

#include "sim/base/error.hpp"
#include "sim/method/collision_rate.hpp"
#include "sim/run/initial.hpp"
#include "sim/run/test_hard.hpp"

#include <gtest/gtest.h>

namespace sandglass::equilibrate_test {
namespace {

template <int D>
Particles<D> start(const Scene& scene, double collisions) {
  Scene changed = scene;
  changed.initial.equilibrate_collisions = collisions;
  return initial_particles<D>(set_up<D>(changed, {}), {1, 0});
}

/// Lossy and rough, under gravity, between lossy walls: none of it may act yet.
Scene harsh(std::vector<double> box, std::uint64_t small, std::uint64_t large) {
  Scene scene = hard_scene(std::move(box), small);
  scene.species[0].restitution = 0.5;
  scene.species[0].tangential_restitution = 0.2;
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "large";
  scene.species[1].count = large;
  scene.species[1].diameter = 1.5;
  scene.species[1].mass = 3;
  scene.gravity.assign(scene.domain.size.size(), -2);
  scene.initial.spin_temperature = 1;
  wall_in(scene, 1);
  Wall hot;
  hot.axis = 1;
  hot.surface.rule = SurfaceKind::thermal;
  hot.surface.temperature = 5;
  hot.velocity.assign(scene.domain.size.size(), 0);
  hot.velocity[0] = 3;
  Wall shaking;
  shaking.axis = 1;
  shaking.high = true;
  shaking.amplitude = 0.3;
  shaking.frequency = 2;
  shaking.surface.restitution = 0.3;
  scene.walls = {hot, shaking};
  Obstacle obstacle;
  obstacle.centre.assign(scene.domain.size.size(), 5);
  obstacle.radius = 2;
  obstacle.surface.restitution = 0.2;
  scene.obstacles = {obstacle};
  return scene;
}

template <int D>
double energy(const Scene& scene, const Particles<D>& particles) {
  double sum = 0;
  const auto species = particles.columns.get(column::species);
  for (std::size_t i = 0; i < particles.phases.size(); ++i)
    sum += scene.species[species[i]].mass * particles.phases[i].velocity.squaredNorm();
  return sum;
}

template <int D>
void expect_elastic(const Scene& scene) {
  const Particles<D> before = start<D>(scene, 0), after = start<D>(scene, 5);
  ASSERT_EQ(after.phases.size(), before.phases.size());
  const auto species = after.columns.get(column::species);
  EXPECT_TRUE(std::ranges::equal(species, before.columns.get(column::species)));
  EXPECT_EQ(species.size(), after.phases.size());
  EXPECT_NEAR(energy(scene, after) / energy(scene, before), 1, 1e-12);
  const auto spins = after.columns.get(column::spin<D>), unchanged = before.columns.get(column::spin<D>);
  ASSERT_EQ(spins.size(), after.phases.size());
  ASSERT_EQ(unchanged.size(), after.phases.size());
  std::size_t unmoved = 0;
  for (std::size_t i = 0; i < after.phases.size(); ++i) {
    ASSERT_EQ(spins[i], unchanged[i]);
    unmoved += after.phases[i].velocity == before.phases[i].velocity;
  }
  EXPECT_LT(unmoved, after.phases.size() / 20);
  EXPECT_GE(narrowest_gap<D>(scene, after.phases, species), -1e-11);
}

TEST(Equilibrate, KeepsEnergySpinsAndSpecies) {
  expect_elastic<2>(harsh({30, 25}, 150, 60));
  expect_elastic<3>(harsh({12, 12, 12}, 120, 40));
}

/// A hundredth of a collision per particle leaves nearly all of them on their straight way, each in its own place.
TEST(Equilibrate, ParticlesKeepTheirOrder) {
  const Scene scene = hard_scene({40, 40}, 400);
  const Particles<2> before = start<2>(scene, 0), after = start<2>(scene, 0.01);
  const double dt = 0.1 / enskog_rate(scene, 1);
  std::size_t straight = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    const Vector<2> moved = after.phases[i].position - before.phases[i].position;
    // The number of steps is not known: the lattice may need some before the first collision.
    for (int steps = 1; steps < 40; ++steps) {
      Vector<2> off = moved - steps * dt * before.phases[i].velocity;
      for (int axis = 0; axis < 2; ++axis) off[axis] = std::remainder(off[axis], 40);
      if (off.norm() > 1e-10) continue;
      ++straight;
      EXPECT_EQ(after.phases[i].velocity, before.phases[i].velocity);
      break;
    }
  }
  EXPECT_GT(straight, 300u);
}

/// From the lattice to a gas: neighbours are no longer kept a spacing apart.
TEST(Equilibrate, LeavesTheLattice) {
  const Scene scene = hard_scene({40, 40}, 400);
  EXPECT_NEAR(narrowest_gap<2>(scene, start<2>(scene, 0).phases), 1, 1e-10);
  EXPECT_LT(narrowest_gap<2>(scene, start<2>(scene, 10).phases), 0.1);
}

TEST(Equilibrate, DoesNotDependOnLossAndFollowsTheSeed) {
  Scene scene = hard_scene({20, 20}, 100);
  const Particles<2> elastic = start<2>(scene, 3);
  scene.species[0].restitution = 0.1;
  const Particles<2> lossy = start<2>(scene, 3);
  for (std::size_t i = 0; i < 100; ++i) ASSERT_EQ(elastic.phases[i].position, lossy.phases[i].position);
  scene.run.seed = 2;
  scene.initial.equilibrate_collisions = 3;
  const auto other = initial_particles<2>(set_up<2>(scene, {}), {2, 0}).phases;
  EXPECT_NE(other[0].position, elastic.phases[0].position);
}

TEST(Equilibrate, SaysWhenNoCollisionComes) {
  Scene scene = hard_scene({10, 10}, 1);
  scene.initial.exact = false;
  wall_in(scene, 0);
  wall_in(scene, 1);
  EXPECT_THROW(start<2>(scene, 1), InputError);
  scene.species[0].count = 2;
  scene.initial.temperature = 0;
  EXPECT_THROW(start<2>(scene, 1), InputError);
}

/// 2 sqrt(pi) n d g sqrt(T/m) for disks and 4 n d^2 g sqrt(pi T/m) for spheres (Enskog), and a mixture of two
/// names for one kind.
TEST(Equilibrate, RateIsEnskogs) {
  Scene disks = hard_scene({10, 10}, 40);
  disks.species[0].diameter = 0.8;
  disks.species[0].mass = 2;
  const double nu = 0.4 * M_PI / 4 * 0.64, henderson = (1 - 7 * nu / 16) / ((1 - nu) * (1 - nu));
  const double wanted = 2 * std::sqrt(M_PI) * 0.4 * 0.8 * henderson * std::sqrt(3.0 / 2);
  EXPECT_NEAR(enskog_rate(disks, 3), wanted, 1e-13 * wanted);
  disks.species.push_back(disks.species[0]);
  disks.species[0].count = 25;
  disks.species[1].count = 15;
  EXPECT_NEAR(enskog_rate(disks, 3), wanted, 1e-13 * wanted);
  const Scene spheres = hard_scene({10, 10, 10}, 300);
  const double volume = 0.3 * M_PI / 6, carnahan = (1 - volume / 2) / std::pow(1 - volume, 3);
  EXPECT_NEAR(enskog_rate(spheres, 1), 4 * 0.3 * carnahan * std::sqrt(M_PI), 1e-12);
}

}  // namespace
}  // namespace sandglass::equilibrate_test
