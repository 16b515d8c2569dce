#include "validation/law/vibrated_bed.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace sandglass::law::vibrated_bed_test {
namespace {

using std::numbers::pi;

/// Energy per collision, times its rate, that a Maxwellian of density one and T/m = 1 takes from a bottom with velocity u:
/// Simpson's rule over all particles that the bottom catches up with.
double power_at(double u, double restitution) {
  constexpr int steps = 2000;
  const double width = (10 + u) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double v = -u + i * width, after = (1 + restitution) * u + restitution * v;
    const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * (v + u) * std::exp(-v * v / 2) * (after * after - v * v) / 2;
  }
  return sum * width / 3 / std::sqrt(2 * pi);
}

/// Mean over the phases of V cos(phase).
double power_of_bottom(double speed, double restitution) {
  constexpr int phases = 32;
  double sum = 0;
  for (int i = 0; i < phases; ++i)
    sum += power_at(speed * std::cos(2 * pi * (i + 0.5) / phases), restitution) / phases;
  return sum;
}

TEST(BottomGain, IsThePowerOfASlowBottom) {
  for (double restitution : {1.0, 0.9, 0.5}) {
    const double loss = (1 - restitution * restitution) / std::sqrt(2 * pi);
    const auto gain = [=](double speed) {
      return (power_of_bottom(speed, restitution) + loss) / (speed * speed / 2);
    };
    // Even in the speed: what is left out is of the order V^2, and goes with it.
    EXPECT_NEAR(gain(0.02), bottom_gain(restitution), 1e-3);
    EXPECT_NEAR((4 * gain(0.1) - gain(0.2)) / 3, bottom_gain(restitution), 1e-4);
  }
}

/// Power in minus power lost per N m, by quadrature over an isothermal column of T/m = x.
double imbalance(const VibratedBed& bed, double x) {
  const double d = 1e-3, particles = bed.layers / std::pow(d, bed.dimension - 1);  // per width or area
  const double rate = bed.gravity / x;
  Gas gas{.dimension = bed.dimension, .diameter = d, .temperature = x, .restitution = bed.restitution};
  const double cooling = quadrature::integral(
      [&](double z) {
        // A thin gas at the local density: cooling rate in proportion, whatever the fraction.
        const double density = particles * rate * std::exp(-rate * z);
        gas.fraction = 1e-12;
        return density * bed.dimension / 2.0 * x * cooling_rate(gas) * density / number_density(gas);
      },
      0, 40 / rate);
  const double flux = std::sqrt(x / (2 * pi));  // per density and area
  const double bottom = particles * rate * flux *
                        (bottom_gain(bed.bottom_restitution) * std::sqrt(2 * pi) * bed.speed * bed.speed / 2 -
                         (1 - bed.bottom_restitution * bed.bottom_restitution) * x);
  const int walls = 2 * (bed.dimension - 1);
  const double sides =
      walls * flux * particles / bed.width * (1 - bed.side_restitution * bed.side_restitution) * x;
  return (bottom - cooling - sides) / (cooling + sides);
}

constexpr VibratedBed kBed{.dimension = 2,
                           .layers = 5,
                           .width = 0.01,
                           .restitution = 0.9,
                           .bottom_restitution = 0.9,
                           .side_restitution = 0.9,
                           .gravity = 9.81,
                           .speed = 0.3};

TEST(VibratedBed, BalancesPowerInAndLost) {
  for (int dimension : {2, 3})
    for (double side : {1.0, 0.9}) {
      VibratedBed bed = kBed;
      bed.dimension = dimension;
      bed.side_restitution = side;
      EXPECT_NEAR(imbalance(bed, vibrated_bed_temperature_over_mass(bed)), 0, 1e-9);
      EXPECT_GT(std::abs(imbalance(bed, 1.01 * vibrated_bed_temperature_over_mass(bed))), 1e-3);
    }
}

TEST(VibratedBed, ExponentIsTheSlopeOfTheRise) {
  for (double speed : {0.01, 0.3, 5.0}) {
    VibratedBed low = kBed, high = kBed, middle = kBed;
    middle.speed = speed;
    low.speed = speed * 0.999;
    high.speed = speed * 1.001;
    const double slope = std::log(vibrated_bed_rise(high) / vibrated_bed_rise(low)) / std::log(1.001 / 0.999);
    EXPECT_NEAR(vibrated_bed_exponent(middle), slope, 1e-6);
  }
}

// Mueller 2001, sec. 3.7: quadratic with elastic walls, linear with elastic particles in inelastic walls.
TEST(VibratedBed, ExponentsGoFromTwoToOne) {
  VibratedBed bed = kBed;
  bed.bottom_restitution = bed.side_restitution = 1;
  EXPECT_DOUBLE_EQ(vibrated_bed_exponent(bed), 2);
  bed = kBed;
  bed.restitution = bed.bottom_restitution = 1;
  EXPECT_DOUBLE_EQ(vibrated_bed_exponent(bed), 1);
}

// Kumaran 1998 for disks in elastic walls: T/m = (4 sqrt(2)/pi) <U^2>/(N d (1 - r^2)).
TEST(VibratedBed, IsKumaransInElasticWalls) {
  VibratedBed bed = kBed;
  bed.restitution = 0.99;
  bed.bottom_restitution = bed.side_restitution = 1;
  const double expected = 4 * std::sqrt(2) / pi * (0.3 * 0.3 / 2) / (5 * (1 - 0.99 * 0.99));
  EXPECT_NEAR(vibrated_bed_temperature_over_mass(bed) / expected, 1, 1e-12);
  EXPECT_NEAR(vibrated_bed_expansion(bed), 0.3 * 0.3 / 2 / expected, 1e-14);
}

}  // namespace
}  // namespace sandglass::law::vibrated_bed_test
