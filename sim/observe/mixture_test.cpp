#include "sim/observe/collisions.hpp"
#include "sim/observe/distribution.hpp"
#include "sim/observe/energy.hpp"
#include "sim/observe/fields.hpp"
#include "sim/observe/sums.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Every observer that knows masses, on random mixtures of three species against plain loops.

namespace sandglass::mixture_test {
namespace {

template <int D>
TestSystem<D> mixture(std::uint64_t seed, std::size_t count = 500) {
  TestSystem<D> system = random_system<D>(Vector<D>::Constant(4), count, seed);
  system.traits = {{1, 2, 0.1}, {2, 0.3, 0.2}, {3, 7, 0.3}};
  Random random(StreamKey(seed, Purpose::velocities, D, 0), 0);
  for (std::size_t i = 0; i < count; ++i)
    system.species.push_back(static_cast<std::uint8_t>(random.bits() % 3));
  return system;
}

template <int D>
double mass(const TestSystem<D>& system, std::size_t i) {
  return system.traits[system.species[i]].mass;
}

template <int D>
Vector<D> momentum(const TestSystem<D>& system) {
  Vector<D> sum = Vector<D>::Zero();
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    sum += mass(system, i) * system.particles[i].velocity;
  return sum;
}

template <int D>
double total_mass(const TestSystem<D>& system) {
  double sum = 0;
  for (std::size_t i = 0; i < system.particles.size(); ++i) sum += mass(system, i);
  return sum;
}

/// Normal velocities of one temperature, whatever the mass: equilibrium (Box & Muller 1958).
template <int D>
void thermalize(TestSystem<D>& system, double temperature, Random& random) {
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    for (int axis = 0; axis < D; ++axis)
      system.particles[i].velocity[axis] = std::sqrt(temperature / mass(system, i)) *
                                           std::sqrt(-2 * std::log(1 - random.uniform())) *
                                           std::cos(2 * M_PI * random.uniform());
}

template <int D>
void expect_sums() {
  auto system = mixture<D>(1);
  double energy = 0, scale = 0;
  for (std::size_t i = 0; i < system.particles.size(); ++i) {
    energy += 3 * mass(system, i) * system.particles[i].velocity.squaredNorm() / 2;
    scale += 3 * mass(system, i) * system.particles[i].velocity.norm();
  }
  EXPECT_NEAR(Energy<D>().measure(system.view())[0] / energy, 1, 1e-14);
  EXPECT_NEAR(MomentumScale<D>().measure(system.view())[0] / scale, 1, 1e-14);
  const auto total = Momentum<D>().measure(system.view());
  for (int axis = 0; axis < D; ++axis)
    EXPECT_NEAR(total[static_cast<std::size_t>(axis)], 3 * momentum(system)[axis], 1e-14 * scale);
}

TEST(Mixture, EnergyAndMomentum) {
  expect_sums<2>();
  expect_sums<3>();
}

template <int D>
void expect_temperature() {
  auto system = mixture<D>(2);
  const Vector<D> mean = momentum(system) / total_mass(system);
  EXPECT_LT((mean_velocity(system.view()) - mean).norm(), 1e-14);
  double heat = 0;
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    heat += mass(system, i) * (system.particles[i].velocity - mean).squaredNorm();
  const auto values = Temperature<D>().measure(system.view());
  EXPECT_NEAR(values[D], heat / (D * (500 - 1)), 1e-13 * heat);
  for (Phase<D>& particle : system.particles) particle.velocity += Vector<D>::Constant(100);
  EXPECT_NEAR(Temperature<D>().measure(system.view())[D] / values[D], 1, 1e-11);
}

TEST(Mixture, TemperatureIsRelativeToTheCentreOfMass) {
  expect_temperature<2>();
  expect_temperature<3>();
}

/// N - 1 degrees of freedom are right for any masses: the mean over many draws of five particles is the temperature.
TEST(Mixture, TemperatureOfFewParticlesHasNoBias) {
  auto system = mixture<3>(3, 5);
  system.species = {0, 1, 2, 2, 1};
  Random random(StreamKey(3, Purpose::crossings, 0, 0), 0);
  const int draws = 20'000;
  double mean = 0;
  for (int draw = 0; draw < draws; ++draw) {
    thermalize(system, 1.5, random);
    mean += temperatures(system.view()).mean() / draws;
  }
  // chi-square of 3 (N - 1) degrees of freedom: relative variance 2 / 12 a draw.
  EXPECT_NEAR(mean, 1.5, 4 * 1.5 * std::sqrt(2.0 / 12 / draws));
}

TEST(Mixture, MomentsInEquilibriumAreMaxwells) {
  auto system = mixture<3>(4, 200'000);
  Random random(StreamKey(4, Purpose::crossings, 0, 0), 0);
  thermalize(system, 2, random);
  const auto values = Moments<3>().measure(system.view());
  EXPECT_NEAR(values[1], 3, 0.05);
  EXPECT_NEAR(values[2], 15, 0.6);
  EXPECT_NEAR(values[4], 5.0 / 3, 0.02);  // <C^4> / <C^2>^2 = (D + 2) / D
}

TEST(Mixture, PressureTakesTheTemperatureOfAll) {
  auto system = mixture<2>(5);
  Pressure<2> pressure;
  pressure.start(system.view());
  system.time = 1;
  const double expected = 3 * 500 * temperatures(system.view()).mean() / 16;
  EXPECT_NEAR(pressure.measure(system.view())[0] / expected, 1, 1e-14);
}

TEST(Mixture, ShearModeIsOfTheMassFlow) {
  auto system = mixture<2>(6);
  double sine = 0;
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    sine += mass(system, i) * system.particles[i].velocity[0] *
            std::sin(2 * M_PI * 2 * system.particles[i].position[1] / 4);
  EXPECT_NEAR(ShearMode<2>(2, false).measure(system.view())[0], 2 * sine / total_mass(system), 1e-14);
}

/// One bin over the box has the values of the whole; a stream a million times faster must not drown them.
TEST(Mixture, FieldsOfOneBinAreThoseOfTheBox) {
  for (double stream : {0.0, 1e6}) {
    auto system = mixture<3>(7);
    for (Phase<3>& particle : system.particles) particle.velocity[1] += stream;
    ObserverSpec spec;
    spec.grid = {1, 1, 1};
    const auto values = Fields<3>(spec).measure(system.view());
    const double rounding = stream == 0 ? 1e-13 : 1e-7;
    EXPECT_DOUBLE_EQ(values[0], 3 * 500 / 64.0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(values[1 + axis], mean_velocity(system.view())[static_cast<int>(axis)], rounding);
    EXPECT_NEAR(values[4], temperatures(system.view()).mean(), rounding);
  }
}

/// A heavy and a light particle in the same bin: u = (3 * 1 - 1 * 1) / 4, and m C^2 over two degrees of freedom.
TEST(Mixture, FieldsOfTwoParticlesByHand) {
  TestSystem<2> system;
  system.add_cell({{{1, 1}, {1, 0}}, {{1, 1}, {-1, 0}}});
  system.traits = {{1, 3, 0}, {1, 1, 0}};
  system.species = {0, 1};
  ObserverSpec spec;
  spec.grid = {1, 1};
  const auto values = Fields<2>(spec).measure(system.view());
  EXPECT_DOUBLE_EQ(values[1], 0.5);
  EXPECT_DOUBLE_EQ(values[3], (3 * 0.25 + 1 * 2.25) / 2);
}

/// A species column of one mass says what no column says.
TEST(Mixture, OfOneMassIsOneSpecies) {
  auto plain = random_system<3>(Vector<3>::Constant(4), 300, 8), labelled = plain;
  labelled.species.assign(300, 0);
  labelled.traits = {{1, plain.mass, 0}};
  const auto expect_same = [&](Observer<3>&& observer) {
    const auto a = observer.measure(plain.view()), b = observer.measure(labelled.view());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(b[i], a[i], 1e-13 * (1 + std::abs(a[i])));
  };
  ObserverSpec spec;
  spec.grid = {2, 2, 2};
  expect_same(Energy<3>());
  expect_same(Temperature<3>());
  expect_same(Momentum<3>());
  expect_same(MomentumScale<3>());
  expect_same(Moments<3>());
  expect_same(Fields<3>(spec));
  expect_same(ShearMode<3>(1, true));
}

}  // namespace
}  // namespace sandglass::mixture_test
