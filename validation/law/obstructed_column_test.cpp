#include "validation/law/obstructed_column.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_bessel.h>
#include <gtest/gtest.h>

namespace sandglass::law::obstructed_column_test {
namespace {

using std::numbers::pi;

ObstructedColumn round(int dimension) { return {{1.5, 0.7, 1.2, 2.0}, dimension, 1.3, {{0.8, 0.5}}}; }

double rate(const ObstructedColumn& column) {
  return column.column.mass * column.column.gravity / column.column.temperature;
}

TEST(ObstructedColumn, WithoutObstaclesIsTheBarometricOne) {
  ObstructedColumn plain = round(3);
  plain.obstacles.clear();
  for (const double z : {-1.0, 0.0, 0.3, 1.9, 3.0})
    EXPECT_NEAR(obstructed_fraction(plain, z), barometric_fraction(plain.column, z), 1e-14);
}

/// Integral of exp(-kz) over a disk: 2 pi R/k I1(kR), over a sphere: 4 pi (kR cosh kR - sinh kR)/k^3, times exp(-k centre).
TEST(ObstructedColumn, FreePartIsThatOfClosedForms) {
  for (const int dimension : {2, 3}) {
    const ObstructedColumn column = round(dimension);
    const double k = rate(column), x = k * 0.5, all = 1.3 * -std::expm1(-2 * k) / k;
    const double out = dimension == 2 ? 2 * pi * 0.5 / k * gsl_sf_bessel_I1(x)
                                      : 4 * pi * (x * std::cosh(x) - std::sinh(x)) / (k * k * k);
    EXPECT_NEAR(floor_force(column), 0.7 * 1.3 / (all - out * std::exp(-0.8 * k)), 1e-8);
  }
}

TEST(ObstructedColumn, FractionIsTheIntegralOverWhatIsFree) {
  for (const int dimension : {2, 3}) {
    const ObstructedColumn column = round(dimension);
    const auto density = [&](double z) {
      const double square = std::max(0.0, 0.25 - (z - 0.8) * (z - 0.8));
      return (1.3 - (dimension == 2 ? 2 * std::sqrt(square) : pi * square)) * std::exp(-rate(column) * z);
    };
    const auto part = [&](double z) {  // apart at the edges of the obstacle
      double sum = 0, from = 0;
      for (const double to : {0.3, 1.3, 2.0}) {
        sum += quadrature::integral(density, std::min(from, z), std::min(to, z));
        from = to;
      }
      return sum;
    };
    for (const double z : {0.2, 0.5, 0.8, 1.29, 1.8})
      EXPECT_NEAR(obstructed_fraction(column, z), part(z) / part(2), 1e-8) << z;
  }
}

/// Archimedes: floor and lid bear the weight and that of what is displaced.
TEST(ObstructedColumn, FloorLessLidIsWeightAndBuoyancy) {
  for (const int dimension : {2, 3}) {
    const ObstructedColumn column = round(dimension);
    const double ground = floor_force(column) / (0.7 * 1.3);  // density at the floor
    const auto displaced = [&](double z) {
      const double square = std::max(0.0, 0.25 - (z - 0.8) * (z - 0.8));
      return (dimension == 2 ? 2 * std::sqrt(square) : pi * square) * ground * std::exp(-rate(column) * z);
    };
    EXPECT_NEAR(floor_force(column) - lid_force(column),
                1.5 * 1.2 * (1 + quadrature::integral(displaced, 0.3, 1.3)), 1e-7);
  }
}

TEST(ObstructedColumn, WithoutGravityIsThePressureOfAnIdealGas) {
  ObstructedColumn column = round(2);
  column.column.gravity = 0;
  EXPECT_NEAR(floor_force(column), 0.7 * 1.3 / (2.6 - pi / 4), 1e-9);
  EXPECT_NEAR(lid_force(column), floor_force(column), 1e-12);
}

}  // namespace
}  // namespace sandglass::law::obstructed_column_test
