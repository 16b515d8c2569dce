#include "sim/base/error.hpp"
#include "sim/run/initial.hpp"
#include "sim/run/initial_species.hpp"
#include "sim/run/test_hard.hpp"

#include <string>

#include <gtest/gtest.h>

namespace sandglass::initial_hard_test {
namespace {

template <int D>
Particles<D> start(const Scene& scene, std::uint64_t replica = 0) {
  return initial_particles<D>(set_up<D>(scene, {}), {scene.run.seed, replica});
}

/// Small light and large heavy particles, rough.
Scene mixture(std::vector<double> box, std::uint64_t small, std::uint64_t large) {
  Scene scene = hard_scene(std::move(box), small);
  scene.species[0].tangential_restitution = 0.3;
  scene.species.push_back(scene.species[0]);
  scene.species[1].name = "large";
  scene.species[1].count = large;
  scene.species[1].diameter = 1.7;
  scene.species[1].mass = 4;
  scene.initial.temperature = 0.7;
  return scene;
}

template <int D>
void expect_exact(const Scene& scene, const Particles<D>& particles, double temperature) {
  Vector<D> momentum = Vector<D>::Zero();
  double energy = 0;
  const auto species = particles.columns.get(column::species);
  const std::size_t count = particles.phases.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double mass = scene.species[species[i]].mass;
    momentum += mass * particles.phases[i].velocity;
    energy += mass * particles.phases[i].velocity.squaredNorm();
  }
  EXPECT_LT(momentum.norm(), 1e-11);
  EXPECT_NEAR(energy / (D * (static_cast<double>(count) - 1)), temperature, 1e-12);
}

TEST(InitialHard, AMixtureHasItsMomentumAndTemperatureExactly) {
  const Scene disks = mixture({60, 50}, 300, 150);
  expect_exact(disks, start<2>(disks), 0.7);
  const Scene spheres = mixture({20, 20, 20}, 300, 150);
  expect_exact(spheres, start<3>(spheres), 0.7);
}

TEST(InitialHard, SpeciesShareTheTemperatureAndKeepTheirNumbers) {
  Scene scene = mixture({400, 400}, 20'000, 10'000);
  const Particles<2> particles = start<2>(scene);
  const auto species = particles.columns.get(column::species);
  std::array<double, 2> count{}, square{}, left{};
  for (std::size_t i = 0; i < particles.phases.size(); ++i) {
    const std::size_t kind = species[i];
    ++count[kind];
    square[kind] += scene.species[kind].mass * particles.phases[i].velocity.squaredNorm();
    left[kind] += particles.phases[i].position[1] < 200;
  }
  EXPECT_EQ(count[0], 20'000);
  EXPECT_EQ(count[1], 10'000);
  for (std::size_t kind = 0; kind < 2; ++kind) {
    EXPECT_NEAR(square[kind] / (2 * count[kind]), 0.7, 4.5 * 0.7 / std::sqrt(count[kind]));
    EXPECT_NEAR(left[kind], count[kind] / 2, 4.5 * std::sqrt(count[kind]) / 2);
  }
  EXPECT_NE(shuffled_species(scene, {1, 0}), shuffled_species(scene, {1, 1}));
  EXPECT_TRUE(std::ranges::equal(species, shuffled_species(scene, {scene.run.seed, 0})));
}

/// I <w^2> / degrees of freedom; I = q m d^2 / 4.
template <int D>
double spin_temperature(const Scene& scene, const Particles<D>& particles, double& fourth) {
  constexpr int kFree = D == 2 ? 1 : 3;
  const auto species = particles.columns.get(column::species);
  const auto spins = particles.columns.get(column::spin<D>);
  double square = 0;
  fourth = 0;
  for (std::size_t i = 0; i < spins.size(); ++i) {
    const Species& kind = scene.species[species[i]];
    const double inertia = (D == 2 ? 0.5 : 0.4) * kind.mass * kind.diameter * kind.diameter / 4;
    square += inertia * spins[i].squaredNorm();
    fourth += inertia * inertia * spins[i].array().pow(4).sum();
  }
  const double all = kFree * static_cast<double>(spins.size());
  fourth /= all * std::pow(square / all, 2);
  return square / all;
}

template <int D>
void expect_spins(Scene scene) {
  double fourth = 0;
  const Particles<D> cold = start<D>(scene);
  for (const Spin<D>& spin : cold.columns.get(column::spin<D>)) ASSERT_TRUE(spin.isZero(0));
  scene.initial.spin_temperature = 1.3;
  const Particles<D> exact = start<D>(scene);
  ASSERT_EQ(exact.columns.get(column::spin<D>).size(), exact.phases.size());
  EXPECT_NEAR(spin_temperature(scene, exact, fourth), 1.3, 1e-12);
  const double all = static_cast<double>(exact.phases.size() * (D == 2 ? 1 : 3));
  EXPECT_NEAR(fourth, 3, 4.5 * std::sqrt(24 / all));
  scene.initial.exact = false;
  EXPECT_NEAR(spin_temperature(scene, start<D>(scene), fourth), 1.3, 4.5 * 1.3 * std::sqrt(2 / all));
  EXPECT_GT(std::abs(spin_temperature(scene, start<D>(scene), fourth) - 1.3), 1e-6);
}

TEST(InitialHard, SpinsAreNormalAtTheirTemperature) {
  expect_spins<2>(mixture({200, 200}, 6000, 2000));
  expect_spins<3>(mixture({40, 40, 40}, 4000, 1500));
}

TEST(InitialHard, SmoothParticlesOfOneSpeciesHaveNoSpinsAndNoSpeciesColumn) {
  const Particles<2> particles = start<2>(hard_scene({20, 20}, 100));
  EXPECT_TRUE(particles.columns.all().empty());
}

TEST(InitialHard, VelocitiesAreThoseOfTheOtherMethods) {
  const Scene hard = hard_scene({20, 20}, 100);
  Scene soft = hard;
  choose(soft.method, "dsmc");
  const auto a = start<2>(hard).phases, b = start<2>(soft).phases;
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].velocity, b[i].velocity);
}

TEST(InitialHard, ASingleParticleIsDrawnButCannotBeExact) {
  Scene scene = hard_scene({5, 5}, 1);
  wall_in(scene, 0);
  EXPECT_THROW(start<2>(scene), InputError);
  scene.initial.exact = false;
  EXPECT_GT(start<2>(scene).phases[0].velocity.norm(), 0);
}

TEST(InitialHard, GivenParticlesAreTakenAsTheyAre) {
  for (const char* preset : {"event-driven", "dsmc"}) {
    Scene scene = hard_scene({10, 10}, 1);
    choose(scene.method, preset);
    scene.species[0].count.reset();
    scene.given = {{{1.0 / 3, 2}, {0.1, -7}, {}, 0}, {{5, 9.7}, {1e-300, 3}, {}, 0}};
    scene.initial.equilibrate_collisions = 0;
    const Particles<2> particles = start<2>(scene);
    ASSERT_EQ(particles.phases.size(), 2u);
    EXPECT_EQ(particles.phases[0].position, Vector<2>(1.0 / 3, 2));
    EXPECT_EQ(particles.phases[1].velocity, Vector<2>(1e-300, 3));
    EXPECT_TRUE(particles.columns.all().empty());
  }
}

TEST(InitialHard, GivenParticlesKeepSpinAndSpecies) {
  Scene scene = mixture({9, 9, 9}, 1, 1);
  scene.given = {{{1, 2, 3}, {0, 0, 1}, {0.1, 0.2, 0.3}, 1}, {{5, 5, 5}, {0, 0, 0}, {}, 0}};
  const Particles<3> particles = start<3>(scene);
  const auto spins = particles.columns.get(column::spin<3>);
  EXPECT_TRUE(std::ranges::equal(particles.columns.get(column::species), std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(spins[0], Spin<3>(0.1, 0.2, 0.3));
  EXPECT_TRUE(spins[1].isZero(0));
}

}  // namespace
}  // namespace sandglass::initial_hard_test
