#include "validation/law/shear_modes.hpp"

#include "validation/law/haff.hpp"
#include "validation/law/transport.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::shear_modes_test {
namespace {

Gas disks(double fraction, double restitution) {
  Gas gas;
  gas.fraction = fraction;
  gas.restitution = restitution;
  return gas;
}

double edge(const Gas& gas, double particles) { return std::sqrt(particles / number_density(gas)); }

// The marginal wave keeps its part of the energy: it decays at k^2 nu while the thermal speed does at zeta/2.
TEST(MarginalWave, DecaysAsTheThermalSpeed) {
  const Gas gas = disks(0.25, 0.9);
  const double k = marginal_wave_number(gas);
  EXPECT_NEAR(k * k * enskog_kinematic_viscosity(gas, SonineOrder::converged), cooling_rate(gas) / 2, 1e-14);
  EXPECT_EQ(marginal_wave_number(disks(0.25, 1)), 0);
}

// Two numbers that the case worked out by hand before its first run.
TEST(MarginalWave, OfHardDisks) {
  EXPECT_NEAR(marginal_wave_length(disks(0.05, 0.8)), 91, 1);
  EXPECT_NEAR(marginal_wave_length(disks(0.25, 0.9)), 25, 1);
}

// A box so small that only the four longest waves are no shorter than a diameter times 2 pi.
TEST(ShearModeShare, OfFourWaves) {
  const Gas gas = disks(0.25, 0.8);
  const double particles = 20, length = edge(gas, particles), k = 2 * std::numbers::pi / length;
  ASSERT_LT(k, 1);
  ASSERT_GT(M_SQRT2 * k, 1);
  const double marginal = std::pow(marginal_wave_number(gas), 2);
  const std::array<double, 2> box = {length, length};
  EXPECT_NEAR(shear_mode_share(gas, box, particles), 4 * marginal / (k * k - marginal) / (2 * 19), 1e-12);
}

TEST(ShearModeShare, IsNothingForElasticGasesAndInfiniteWhereAWaveGrows) {
  const std::array<double, 2> small = {20, 20}, large = {100, 100};
  EXPECT_EQ(shear_mode_share(disks(0.25, 1), small, 100), 0);
  EXPECT_EQ(shear_mode_share(disks(0.25, 0.8), large, 3000), HUGE_VAL);
}

}  // namespace
}  // namespace sandglass::law::shear_modes_test
