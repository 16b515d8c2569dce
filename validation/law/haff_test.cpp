#include "validation/law/haff.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/contact_average.hpp"
#include "validation/law/enskog.hpp"

#include <array>
#include <numbers>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

namespace sandglass::law::haff_test {
namespace {

using std::numbers::pi;

const Gas kDisks{
    .dimension = 2, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.25, .restitution = 0.8};
const Gas kSpheres{
    .dimension = 3, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.2, .restitution = 0.8};

/// Energy lost in all contacts over the energy that there is, per time.
double pair_cooling_rate(const Gas& gas) {
  const double directions = gas.dimension == 2 ? 2 * pi : 4 * pi;
  const double contacts = number_density(gas) / 2 * contact_value(gas.dimension, gas.fraction) * directions *
                          std::pow(gas.diameter, gas.dimension - 1) *
                          std::sqrt(2 * gas.temperature / gas.mass);
  const double loss = contact_average(gas.dimension, gas.restitution, [](const Contact& contact) {
    return contact.first.squaredNorm() + contact.second.squaredNorm() - contact.first_after.squaredNorm() -
           contact.second_after.squaredNorm();
  });
  return contacts * loss / (gas.dimension / 2.0);
}

struct Cooled {
  double temperature, collisions;
};

int derivatives(double, const double state[], double change[], void* parameters) {
  Gas gas = *static_cast<const Gas*>(parameters);
  gas.temperature = state[0];
  change[0] = -cooling_rate(gas) * gas.temperature;
  change[1] = collision_rate(gas);
  return GSL_SUCCESS;
}

/// dT/dt = -zeta(T) T and dtau/dt = omega(T), followed numerically.
Cooled integrate(Gas gas, double duration) {
  gsl_set_error_handler_off();
  gsl_odeiv2_system system{derivatives, nullptr, 2, &gas};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4, 0, 1e-11), gsl_odeiv2_driver_free);
  std::array<double, 2> state{gas.temperature, 0};
  double time = 0;
  EXPECT_EQ(gsl_odeiv2_driver_apply(driver.get(), &time, duration, state.data()), GSL_SUCCESS);
  return {state[0], state[1]};
}

TEST(CoolingRate, IsTheEnergyLostInContacts) {
  for (const Gas& gas : {kDisks, kSpheres}) EXPECT_NEAR(cooling_rate(gas) / pair_cooling_rate(gas), 1, 1e-12);
}

TEST(HaffLaw, SolvesTheCoolingEquation) {
  for (const Gas& gas : {kDisks, kSpheres}) {
    const double scale = haff_time_scale(gas);
    for (double time : {0.1 * scale, scale, 50 * scale}) {
      const Cooled cooled = integrate(gas, time);
      const double ratio = cooled.temperature / gas.temperature;
      EXPECT_NEAR(haff_energy_ratio(time, scale) / ratio, 1, 1e-8);
      EXPECT_NEAR(haff_collisions(collision_rate(gas), time, scale) / cooled.collisions, 1, 1e-8);
      EXPECT_NEAR(haff_energy_ratio_of_collisions(gas.dimension, gas.restitution, cooled.collisions) / ratio,
                  1, 1e-8);
    }
  }
}

// Müller (2001) eq. (3.2), with v = sqrt(2E/(Nm)) = sqrt(2T/m) in 2D.
TEST(HaffTimeScale, IsMullersForDisks) {
  const double speed = std::sqrt(2 * kDisks.temperature / kDisks.mass);
  const double expected = std::sqrt(pi) * kDisks.diameter / contact_value(2, kDisks.fraction) /
                          (std::sqrt(2) * (1 - 0.8 * 0.8) * kDisks.fraction * speed);
  EXPECT_NEAR(haff_time_scale(kDisks), expected, 1e-13);
}

TEST(HaffTimeScale, SonineCorrectionFollowsTheSignOfA2) {
  Gas gas = kDisks;
  gas.restitution = 0.9;  // a2 < 0: fewer fast pairs, slower cooling
  EXPECT_GT(haff_time_scale_sonine(gas), haff_time_scale(gas));
  gas.restitution = 0.5;
  EXPECT_LT(haff_time_scale_sonine(gas), haff_time_scale(gas));
  gas.restitution = std::sqrt(0.5);
  EXPECT_NEAR(haff_time_scale_sonine(gas), haff_time_scale(gas), 1e-13);
}

TEST(HaffTimeScale, IsInfiniteForElasticParticles) {
  Gas gas = kDisks;
  gas.restitution = 1;
  EXPECT_TRUE(std::isinf(haff_time_scale(gas)));
}

}  // namespace
}  // namespace sandglass::law::haff_test
