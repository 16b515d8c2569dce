#include "validation/law/mixture.hpp"

#include "sim/base/random.hpp"
#include "sim/base/statistics.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/state.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

namespace sandglass::law::mixture_test {
namespace {

TEST(Mixture, OfOneSpeciesIsTheGas) {
  for (const int dimension : {2, 3}) {
    const Gas gas{dimension, 0.7, 1.3, 2.1, 0.2, 1};
    const Component one{number_density(gas), 0.7, 1.3, 2.1};
    const double contact = mixture_contact_value(dimension, {one}, 0, 0);
    EXPECT_NEAR(contact, contact_value(dimension, 0.2), 1e-12);
    EXPECT_NEAR(mixture_collision_rate(dimension, one, one, contact), collision_rate(gas), 1e-12);
    EXPECT_NEAR(mixture_compressibility(dimension, {one}), compressibility_factor(gas), 1e-12);
    // Two halves of one gas.
    Component half = one;
    half.number_density /= 2;
    for (const std::size_t j : {0u, 1u})
      EXPECT_NEAR(mixture_contact_value(dimension, {half, half}, 0, j), contact, 1e-12);
  }
}

/// A point among spheres meets them at 1/(1 - nu), the chance that its place is free; in 2D alike.
TEST(Mixture, ContactValueOfAPointIsOneOverTheRoom) {
  for (const int dimension : {2, 3})
    EXPECT_NEAR(mixture_contact_value(dimension, {{0.3, 1, 1, 1}, {1e-9, 1e-9, 1, 1}}, 0, 1),
                1 / (1 - 0.3 * std::acos(-1) / (dimension == 2 ? 4 : 6)), 1e-8);
}

/// Third virial coefficient of additive hard spheres of two sizes, Kihara: to first order in density
/// g_12 = 1 + sum over k of n_k V_k(1,2), V_k the common volume of two spheres of radii d_1k and d_2k around centres d_12
/// apart; here by the closed form of the lens.
TEST(Mixture, ContactValueHasTheRightFirstOrder) {
  const double d_1 = 1, d_2 = 1.7, density = 1e-5;
  const auto lens = [](double r, double s, double distance) {
    return std::acos(-1) * std::pow(r + s - distance, 2) *
           (distance * distance + 2 * distance * (r + s) - 3 * std::pow(r - s, 2)) / (12 * distance);
  };
  for (const double d_k : {1.0, 1.7, 0.4}) {
    const double expected = density * lens((d_1 + d_k) / 2, (d_2 + d_k) / 2, (d_1 + d_2) / 2);
    const double value =
        mixture_contact_value(3, {{0, d_1, 1, 1}, {0, d_2, 1, 1}, {density, d_k, 1, 1}}, 0, 1) - 1;
    EXPECT_NEAR(value / expected, 1, 1e-4) << d_k;
  }
}

/// The energy of a collision by brute force: Maxwellian pairs of two temperatures, weighted by their speed of approach.
void expect_energy_change(double restitution, const Component& one, const Component& two) {
  Random random(StreamKey(5, Purpose::velocities, 0, 0), 0);
  boost::random::normal_distribution<double> normal;
  const double reduced = one.mass * two.mass / (one.mass + two.mass);
  std::vector<double> gains, weights;
  for (int i = 0; i < 400'000; ++i) {
    const double v_1 = std::sqrt(one.temperature / one.mass) * normal(random);
    const double v_2 = std::sqrt(two.temperature / two.mass) * normal(random);
    const double weight = std::max(0.0, v_2 - v_1);  // only the components along the normal change
    const double after = v_1 + (1 + restitution) * reduced / one.mass * (v_2 - v_1);
    gains.push_back(weight * one.mass / 2 * (after * after - v_1 * v_1));
    weights.push_back(weight);
  }
  const double total = mean_of_independent(weights).value;
  const Mean gain = mean_of_independent(gains);
  EXPECT_NEAR(gain.value / total, mixture_energy_change(restitution, one, two),
              6 * gain.standard_error / total);
  EXPECT_LT(gain.standard_error / total, 0.01);
}

TEST(Mixture, EnergyChangeIsThatOfCollidingPairs) {
  expect_energy_change(1, {1, 1, 1, 1}, {1, 1, 5, 2});
  expect_energy_change(0.7, {1, 1, 1, 1}, {1, 1, 5, 1});
  expect_energy_change(0.4, {1, 1, 3, 2}, {1, 1, 1, 0.5});
}

TEST(Mixture, TemperatureRatioHasItsLimits) {
  for (const int dimension : {2, 3}) {
    const Component light{0.1, 1, 1, 1}, heavy{0.05, 1.5, 8, 1};
    EXPECT_NEAR(mixture_temperature_ratio(dimension, 1, light, heavy), 1, 1e-9);
    EXPECT_NEAR(mixture_temperature_ratio(dimension, 0.7, light, light), 1, 1e-9);
    const double ratio = mixture_temperature_ratio(dimension, 0.7, light, heavy);
    EXPECT_LT(ratio, 1);  // the lighter loses more (Garzo & Dufty 1999)
    EXPECT_NEAR(ratio * mixture_temperature_ratio(dimension, 0.7, heavy, light), 1, 1e-9);
    EXPECT_GT(ratio, mixture_temperature_ratio(dimension, 0.5, light, heavy));
  }
}

/// Elastic species that differ in temperature exchange what one loses and the other gains.
TEST(Mixture, ElasticSpeciesExchangeEnergy) {
  const Component cold{1, 1, 1, 1}, hot{1, 1, 5, 3};
  EXPECT_NEAR(mixture_energy_change(1, cold, hot), -mixture_energy_change(1, hot, cold), 1e-12);
  EXPECT_GT(mixture_energy_change(1, cold, hot), 0);
}

}  // namespace
}  // namespace sandglass::law::mixture_test
