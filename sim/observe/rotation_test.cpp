#include "sim/observe/rotation.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/spin_temperature.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::rotation_test {
namespace {

template <int D>
TestSystem<D> spinning(std::size_t count, std::uint64_t seed) {
  TestSystem<D> system = random_system<D>(Vector<D>::Constant(4), count, seed);
  Random random(StreamKey(seed, Purpose::velocities, D, 0), 0);
  for (std::size_t i = 0; i < count; ++i) {
    Spin<D> spin;
    for (int axis = 0; axis < spin.size(); ++axis) spin[axis] = 3 * random.uniform() - 1;
    system.spins.push_back(spin);
  }
  system.traits = {{1, 2, 0.4}};
  return system;
}

/// Energy 3 sum I w^2 / 2 of the real particles (weight 3); temperature <I w^2> / freedom.
template <int D>
void expect_energy(TestSystem<D>& system, double freedom) {
  double twice = 0;
  for (std::size_t i = 0; i < system.spins.size(); ++i)
    twice +=
        system.traits[system.species.empty() ? 0 : system.species[i]].inertia * system.spins[i].squaredNorm();
  RotationalEnergy<D> energy;
  energy.start(system.view());
  EXPECT_NEAR(energy.measure(system.view())[0] / (1.5 * twice), 1, 1e-14);
  const double temperature = twice / static_cast<double>(system.spins.size()) / freedom;
  EXPECT_NEAR(RotationalTemperature<D>().measure(system.view())[0] / temperature, 1, 1e-14);
}

TEST(Rotation, OfOneSpecies) {
  auto disks = spinning<2>(100, 1);
  auto spheres = spinning<3>(100, 2);
  expect_energy(disks, 1);
  expect_energy(spheres, 3);
}

TEST(Rotation, OfAMixture) {
  auto disks = spinning<2>(100, 3);
  auto spheres = spinning<3>(100, 4);
  for (std::size_t i = 0; i < 100; ++i) {
    disks.species.push_back(i % 3 == 0);
    spheres.species.push_back(i % 5 == 0);
  }
  disks.traits.push_back({2, 5, 7});
  spheres.traits.push_back({2, 5, 7});
  expect_energy(disks, 1);
  expect_energy(spheres, 3);
}

/// The bins together hold the energy of all: mean over particles of what their bin shows.
TEST(Rotation, OfBinsAddsUp) {
  auto spheres = spinning<3>(100, 6);
  for (std::size_t i = 0; i < 100; ++i) spheres.species.push_back(i % 5 == 0);
  spheres.traits.push_back({2, 5, 7});
  ObserverSpec spec;
  spec.grid = {2, 1, 4};
  SpinTemperature<3> bins(spec);
  bins.start(spheres.view());
  const std::vector<double> values = bins.measure(spheres.view());
  ASSERT_EQ(values.size(), 8u);
  double sum = 0;
  for (const Phase<3>& particle : spheres.particles) {
    const double x = std::floor(particle.position[0] / 2), z = std::floor(particle.position[2]);
    sum += values[static_cast<std::size_t>(4 * x + z)];
  }
  EXPECT_NEAR(sum / 100 / RotationalTemperature<3>().measure(spheres.view())[0], 1, 1e-13);
}

TEST(Rotation, SmoothParticlesAreRefused) {
  auto system = random_system<2>(Vector<2>::Constant(4), 10, 5);
  ObserverSpec spec;
  spec.grid = {1, 1};
  EXPECT_THROW(SpinTemperature<2>(spec).start(system.view()), InputError);
  EXPECT_THROW(RotationalEnergy<2>().start(system.view()), InputError);
  EXPECT_THROW(RotationalTemperature<2>().start(system.view()), InputError);
}

TEST(Rotation, NobodyHasNoTemperature) {
  TestSystem<2> nobody;
  EXPECT_EQ(RotationalTemperature<2>().measure(nobody.view()), std::vector<double>{0});
}

}  // namespace
}  // namespace sandglass::rotation_test
