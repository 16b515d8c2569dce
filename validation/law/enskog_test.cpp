#include "validation/law/enskog.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/quadrature.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::enskog_test {
namespace {

using std::numbers::pi;

const Gas kDisks{.dimension = 2, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.25};
const Gas kSpheres{.dimension = 3, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.2};

/// Mean length of a Gaussian vector whose components have the given variance.
double mean_length(int dimension, double variance) {
  const auto density = [=](double v) {
    return std::pow(v, dimension - 1) * std::exp(-v * v / (2 * variance));
  };
  const double far = 40 * std::sqrt(variance);
  return quadrature::integral([=](double v) { return v * density(v); }, 0, far) /
         quadrature::integral(density, 0, far);
}

TEST(NumberDensity, CountsParticlesOfTheGivenFraction) {
  EXPECT_DOUBLE_EQ(number_density(kDisks) * pi * 0.35 * 0.35, 0.25);
  EXPECT_DOUBLE_EQ(number_density(kSpheres) * 4 * pi / 3 * 0.35 * 0.35 * 0.35, 0.2);
}

// A particle sweeps cross section times relative speed; the relative velocity has variance 2T/m.
TEST(CollisionRate, IsSweptVolumeTimesDensityAtContact) {
  for (const Gas& gas : {kDisks, kSpheres}) {
    const double cross_section = gas.dimension == 2 ? 2 * gas.diameter : pi * gas.diameter * gas.diameter;
    const double swept = cross_section * mean_length(gas.dimension, 2 * gas.temperature / gas.mass);
    EXPECT_NEAR(
        collision_rate(gas) / (swept * number_density(gas) * contact_value(gas.dimension, gas.fraction)), 1,
        1e-9);
  }
}

TEST(MeanSpeed, IsTheFirstMoment) {
  for (const Gas& gas : {kDisks, kSpheres})
    EXPECT_NEAR(mean_speed(gas), mean_length(gas.dimension, gas.temperature / gas.mass), 1e-9);
}

TEST(MeanFreePath, HasTheTextbookDiluteForm) {
  Gas disks = kDisks, spheres = kSpheres;
  disks.fraction = spheres.fraction = 1e-9;
  EXPECT_NEAR(mean_free_path(disks) * 2 * std::sqrt(2) * number_density(disks) * 0.7, 1, 1e-8);
  EXPECT_NEAR(mean_free_path(spheres) * std::sqrt(2) * pi * number_density(spheres) * 0.49, 1, 1e-8);
}

// Baryshev (2003) ch. 4: the event-driven mean free time is 0.43 at nu = 0.65, T = 0.02; Enskog says 0.413.
TEST(CollisionRate, GivesBaryshevsEnskogTime) {
  const Gas gas{.dimension = 2, .temperature = 0.02, .fraction = 0.65};
  EXPECT_NEAR(1 / collision_rate(gas), 0.413, 0.0005);
}

}  // namespace
}  // namespace sandglass::law::enskog_test
