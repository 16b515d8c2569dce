#include "sim/run/initial.hpp"

#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/run/test_scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::initial_test {
namespace {

template <int D>
std::vector<Phase<D>> start(const Scene& scene, std::uint64_t replica = 0) {
  return initial_particles<D>(set_up<D>(scene, {}), {scene.run.seed, replica}).phases;
}

template <int D>
struct Gas {
  Vector<D> mean = Vector<D>::Zero();
  double temperature = 0;  ///< N - 1 degrees of freedom an axis
  double fourth = 0;       ///< <v_i^4> / <v_i^2>^2 over all axes, relative to the mean
};

template <int D>
Gas<D> gas(const std::vector<Phase<D>>& particles, double mass) {
  Gas<D> result;
  const auto count = static_cast<double>(particles.size());
  for (const auto& particle : particles) result.mean += particle.velocity / count;
  double squares = 0, fourths = 0;
  for (const auto& particle : particles) {
    const Vector<D> relative = particle.velocity - result.mean;
    squares += relative.squaredNorm();
    fourths += relative.array().pow(4).sum();
  }
  result.temperature = mass * squares / (D * (count - 1));
  result.fourth = fourths / (D * count) / std::pow(squares / (D * count), 2);
  return result;
}

template <int D>
void expect_exact_state() {
  Scene scene = test_scene(D, 10, 200);
  scene.species[0].mass = 3;
  scene.initial.temperature = 0.7;
  const Gas<D> at_rest = gas(start<D>(scene), 3);
  EXPECT_LT(at_rest.mean.norm(), 1e-15);
  EXPECT_NEAR(at_rest.temperature, 0.7, 1e-14);
  scene.initial.velocity.assign(D, 2.5);
  const Gas<D> stream = gas(start<D>(scene), 3);
  EXPECT_LT((stream.mean - Vector<D>::Constant(2.5)).norm(), 1e-14);
  EXPECT_NEAR(stream.temperature, 0.7, 1e-13);
}

TEST(Initial, MomentumAndTemperatureAreExact) {
  expect_exact_state<2>();
  expect_exact_state<3>();
}

TEST(Initial, SampledStateScattersAboutIt) {
  Scene scene = test_scene(2, 10, 100);
  scene.initial.exact = false;
  std::vector<double> temperatures;
  for (std::uint64_t replica = 0; replica < 2000; ++replica) {
    const Gas<2> sampled = gas(start<2>(scene, replica), 1);
    EXPECT_GT(sampled.mean.norm(), 1e-8);
    temperatures.push_back(sampled.temperature);
  }
  const Mean mean = mean_of_independent(temperatures);
  EXPECT_NEAR(mean.value, 1, 4.5 * mean.standard_error);
  EXPECT_NEAR(mean.standard_error, std::sqrt(2 / (2 * 99.0) / 2000), 0.1 * mean.standard_error);
}

/// <v^4> = 3 <v^2>^2; its standard error over n Gaussian numbers is sqrt(24 / n).
TEST(Initial, VelocitiesAreMaxwellian) {
  const Scene scene = test_scene(3, 10, 100'000);
  EXPECT_NEAR(gas(start<3>(scene), 1).fourth, 3, 4.5 * std::sqrt(24 / 3e5));
}

TEST(Initial, ShearWaveHasItsAmplitude) {
  Scene scene = test_scene(2, 10, 4000);
  scene.initial.positions = Positions::lattice;
  scene.initial.temperature = 0;
  scene.initial.shear_wave = {0.3, 2};
  for (const Phase<2>& particle : start<2>(scene)) {
    EXPECT_NEAR(particle.velocity[0], 0.3 * std::sin(2 * M_PI * 2 * particle.position[1] / 10), 1e-14);
    EXPECT_EQ(particle.velocity[1], 0);
  }
}

TEST(Initial, EquilibrationKeepsTheStateAndMixesIt) {
  Scene scene = test_scene(3, 10, 2000);
  scene.species[0].restitution = 0.5;  // of the run, not of the equilibration
  scene.initial.positions = Positions::lattice;
  const auto before = start<3>(scene);
  scene.initial.equilibrate_collisions = 3;
  const auto after = start<3>(scene);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_LT(gas(after, 1).mean.norm(), 1e-14);
  EXPECT_NEAR(gas(after, 1).temperature, 1, 1e-13);
  EXPECT_NEAR(gas(after, 1).fourth, 3, 4.5 * std::sqrt(24 / 6e3));
  std::size_t unchanged = 0;
  for (std::size_t i = 0; i < after.size(); ++i) unchanged += after[i].velocity == before[i].velocity;
  EXPECT_LT(unchanged, 20u);
}

TEST(Initial, EquilibrationThatCannotEndSaysSo) {
  Scene scene = test_scene(2, 100, 2);
  dsmc_options(scene).cells = {10, 1};
  scene.initial.positions = Positions::lattice;
  scene.initial.temperature = 0;
  scene.initial.equilibrate_collisions = 1;
  EXPECT_THROW(start<2>(scene), InputError);
}

}  // namespace
}  // namespace sandglass::initial_test
