#include "sim/method/dsmc/pair_deficit.hpp"
#include "sim/method/dsmc/test_gas.hpp"

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

// The gas whose partners stand a diameter away, over many collisions: rate and pressure of Enskog's theory, less the pairs
// that the method is known to miss (pair_deficit.hpp). Statistical bounds are 4.5 standard errors.

namespace sandglass::dsmc::contact_gas_test {
namespace {

constexpr double kFraction = 0.25, kPerCell = 10, kEdge = 1;
constexpr double kCollisions = 0.1;  // of a particle in a step

template <int D>
Parameters contact_gas(double restitution) {
  Parameters parameters;
  parameters.cross_section = cross_section(D, 1);
  parameters.restitution = restitution;
  parameters.weight = kFraction / particle_volume(D, 1) * std::pow(kEdge, D) / kPerCell;
  parameters.factor.formula = contact_formula(D);
  parameters.partners = Partners::contact;
  parameters.measure_transfer = true;
  return parameters;
}

/// Of Enskog, at temperature one.
template <int D>
double collision_rate() {
  return (D == 2 ? 2 : 4) * std::sqrt(M_PI) * kFraction / particle_volume(D, 1) *
         contact_formula(D)(kFraction).value;
}

template <int D>
double temperature(Dsmc<D>& dsmc) {
  double square = 0;
  for (const Phase<D>& particle : dsmc.view().particles) square += particle.velocity.squaredNorm();
  return square / (D * static_cast<double>(dsmc.size()));
}

struct Measured {
  Mean rate, pressure;  ///< over theory, less one
};

/// A box of so many cells along each axis, five collisions of a particle to settle and the rest measured; the step follows
/// the temperature. Of an inelastic gas the box must be short, or vortices grow.
template <int D>
Measured measure(Parameters parameters, std::uint32_t cells, int steps) {
  constexpr int kWarm = 50;
  const Grid<D> grid = cubic_grid<D>(cells, kEdge);
  const auto count = static_cast<std::size_t>(kPerCell * grid.size());
  Dsmc<D> dsmc(grid, parameters, {}, {});
  dsmc.assign({maxwellian<D>(count, cells * kEdge), {}});
  const double hard_core =
      std::exp2(D - 1) * kFraction * contact_formula(D)(kFraction).value * (1 + parameters.restitution) / 2;
  std::vector<double> rates, pressures;
  for (int step = 0; step < kWarm + steps; ++step) {
    const double before = temperature(dsmc), dt = kCollisions / collision_rate<D>() / std::sqrt(before);
    dsmc.tally() = Tally{};
    dsmc.step(dt, static_cast<std::uint64_t>(step));
    if (step < kWarm) continue;
    const double mean = std::sqrt(before * temperature(dsmc)), particles = static_cast<double>(count);
    rates.push_back(2 * static_cast<double>(dsmc.tally().collisions) / particles / kCollisions - 1);
    pressures.push_back(dsmc.tally().transfer.value() / (D * particles * mean * dt * hard_core) - 1);
  }
  return {mean_of_correlated(rates), mean_of_correlated(pressures)};
}

template <int D>
double missing(const Parameters& parameters) {
  return expected_pair_deficit(D, parameters, kFraction / particle_volume(D, 1), kPerCell);
}

template <int D>
void expect_enskog(double restitution, std::uint32_t cells, int steps) {
  const Parameters parameters = contact_gas<D>(restitution);
  const Measured measured = measure<D>(parameters, cells, steps);
  const double expected = -missing<D>(parameters), model = 0.2 * std::abs(expected) + 0.001;
  std::printf("%dD, r = %.1f: rate %+.4f +- %.4f, pressure %+.4f +- %.4f, expected %+.4f\n", D, restitution,
              measured.rate.value, measured.rate.standard_error, measured.pressure.value,
              measured.pressure.standard_error, expected);
  EXPECT_LT(measured.pressure.standard_error, 0.004);
  EXPECT_NEAR(measured.pressure.value, expected, model + 4.5 * measured.pressure.standard_error);
  if (restitution < 1) return;  // the rate then feels the shape of the distribution, the pressure does not
  EXPECT_LT(measured.rate.standard_error, 0.004);
  EXPECT_NEAR(measured.rate.value, expected, model + 4.5 * measured.rate.standard_error);
}

TEST(ContactGas, HasEnskogsRateAndTheHardCorePressure) {
  expect_enskog<2>(1, 28, 400);
  expect_enskog<3>(1, 9, 400);
}

TEST(ContactGas, HasTheHardCorePressureWhenInelastic) {
  expect_enskog<2>(0.8, 12, 2000);
  expect_enskog<3>(0.8, 9, 400);
}

TEST(ContactGas, PlantedHalfDistanceLosesHalfThePressure) {
  Parameters faulty = contact_gas<2>(1);
  faulty.faults.reach = 0.5;
  const Measured measured = measure<2>(faulty, 28, 400);
  EXPECT_NEAR(measured.pressure.value, -0.5, 0.02);
  EXPECT_NEAR(measured.rate.value, 0, 0.03);
}

/// Nothing acts across a wall but the wall: kinetic pressure there, n_w T, is the pressure of the gas. What drew partners
/// from beyond it would keep the gas away; what acted twice would press it on.
TEST(ContactGas, PressesOnAWallWithItsWholePressure) {
  const Parameters parameters = contact_gas<2>(1);
  const Grid<2> grid({8, 24}, {8, 24});
  motion::MotionParameters<2> motion;
  motion.walled[0] = true;
  Dsmc<2> dsmc(grid, parameters, motion, {});
  auto particles = maxwellian<2>(1920, 8);
  for (std::size_t i = 0; i < particles.size(); ++i) particles[i].position[1] *= 3;
  dsmc.assign({particles, {}});
  std::vector<double> at_wall, middle;
  for (std::uint64_t step = 0; step < 6000; ++step) {
    dsmc.step(kCollisions / collision_rate<2>(), step);
    if (step < 300 || step % 5 != 0) continue;
    std::array<double, 2> near{};
    double bulk = 0;
    for (const Phase<2>& particle : dsmc.view().particles) {
      const double depth = std::min(particle.position[0], 8 - particle.position[0]);
      if (depth < 0.2) ++near[depth > 0.1];
      bulk += depth > 2;
    }
    // Per area, straight from the middles of the two layers to the wall.
    at_wall.push_back((1.5 * near[0] - 0.5 * near[1]) / (2 * 0.1 * 24) * parameters.weight);
    middle.push_back(bulk / (4 * 24) * parameters.weight);
  }
  const Mean wall = mean_of_correlated(at_wall), bulk = mean_of_correlated(middle);
  const double fraction = bulk.value * particle_volume(2, 1);
  const double pressure = bulk.value * (1 + 2 * fraction * henderson(fraction).value);
  std::printf("density at the wall %.4f +- %.4f, pressure over temperature %.4f\n", wall.value,
              wall.standard_error, pressure);
  EXPECT_LT(wall.standard_error, 0.02 * pressure);
  // A hundredth for the missing pairs, a hundredth for the curvature of the profile.
  EXPECT_NEAR(wall.value, pressure, 0.02 * pressure + 4.5 * wall.standard_error);
  EXPECT_GT(pressure, 1.5 * bulk.value);
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

TEST(ContactGas, GoesOnBitwiseFromItsParticles) {
  const Grid<3> grid = cubic_grid<3>(4, kEdge);
  motion::MotionParameters<3> motion;
  motion.walled[2] = true;
  Dsmc<3> whole(grid, contact_gas<3>(0.8), motion, {}), resumed(grid, contact_gas<3>(0.8), motion, {});
  whole.assign({maxwellian<3>(640, 4), {}});
  std::uint64_t step = 0;
  for (; step < 10; ++step) whole.step(0.02, step);
  whole.tally() = Tally{};
  const auto half_way = whole.view().particles;
  resumed.assign({{half_way.begin(), half_way.end()}, {}});
  resumed.load(whole.save());
  for (; step < 20; ++step) {
    whole.step(0.02, step);
    resumed.step(0.02, step);
  }
  EXPECT_GT(whole.tally().collisions, 150u);
  EXPECT_EQ(whole.tally().transfer.value(), resumed.tally().transfer.value());
  EXPECT_TRUE(std::ranges::equal(whole.view().particles, resumed.view().particles, same<3>));
}

}  // namespace
}  // namespace sandglass::dsmc::contact_gas_test
