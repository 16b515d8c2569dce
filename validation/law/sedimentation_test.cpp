#include "validation/law/sedimentation.hpp"

#include "validation/law/quadrature.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::law::sedimentation_test {
namespace {

using quadrature::integral;

/// Kawasaki's column: lengths in mean free paths, speeds in sqrt(2 T0/m), so that T0 = 1/2.
MixedColumn kawasaki(std::vector<ColumnSpecies> species, double freedom = 6) {
  return {std::move(species), 0.1, freedom};
}

const Column kColumn{1.3, 0.7, 0.9, 2.4};

/// Boltzmann's factor, integrated.
double average(const Column& column, const std::function<double(double)>& value) {
  const auto factor = [&](double z) {
    return std::exp(-column.mass * column.gravity * z / column.temperature);
  };
  return integral([&](double z) { return factor(z) * value(z); }, 0, column.height) /
         integral(factor, 0, column.height);
}

TEST(Column, HeightAndVarianceAreAveragesOverBoltzmannsFactor) {
  for (const double gravity : {1e-4, 0.9, 30.0}) {
    const Column column{1.3, 0.7, gravity, 2.4};
    const double mean = average(column, [](double z) { return z; });
    const double variance = average(column, [mean](double z) { return (z - mean) * (z - mean); });
    EXPECT_NEAR(mean_column_height(column) / mean, 1, 1e-7) << gravity;
    const double unit = 1.3 * gravity / 0.7;
    EXPECT_NEAR(column_height_variance(column) / (unit * unit * variance), 1, 1e-6) << gravity;
  }
}

/// The integral per cell is the share of barometric_fraction.
TEST(Column, DensityIntegratesToTheShareBelow) {
  for (const double z : {0.3, 1.1, 2.4}) {
    const double below = integral([](double at) { return column_density(kColumn, at); }, 0, z) / 2.4;
    EXPECT_NEAR(below, barometric_fraction(kColumn, z), 1e-10);
  }
}

/// The balance of forces (B.3), by differences: d(n T)/dz = -m g n.
TEST(Column, DensityCarriesTheWeightAbove) {
  const double step = 1e-5;
  for (const double z : {0.2, 1.0, 2.0}) {
    const double slope = (column_density(kColumn, z + step) - column_density(kColumn, z - step)) / (2 * step);
    EXPECT_NEAR(slope * 0.7, -1.3 * 0.9 * column_density(kColumn, z), 1e-8);
  }
}

/// The energy (B.4) of the whole column by integrals, at the temperature that the law gives.
TEST(Sedimentation, KeepsTheEnergyOfAnEvenStart) {
  const MixedColumn column = kawasaki({{1.0, 0.3, 10}, {0.1, 0.7, 10}});
  const double start = 3 * 0.5 + integral([](double y) { return (0.3 + 0.07) * 0.1 * y / 10; }, 0, 10);
  EXPECT_NEAR(even_column_energy(column, 0.5), start, 1e-12);
  const double end = sedimentation_temperature(column, start);
  double potential = 0;
  for (const ColumnSpecies& species : column.species)
    potential += species.share * species.mass * 0.1 *
                 average({species.mass, end, 0.1, 10}, [](double z) { return z; });
  EXPECT_NEAR(3 * end + potential, start, 1e-10);
  EXPECT_GT(end, 0.5);
}

/// The balance as docs/errata.md restores (B.7), term by term.
TEST(Sedimentation, SolvesTheRestoredBalance) {
  const MixedColumn column = kawasaki({{1.0, 0.3, 10}, {0.1, 0.7, 10}});
  const double end = sedimentation_temperature(column, even_column_energy(column, 0.5));
  double left = 6 * 10 * 0.5 / 2, right = (1 + 6 / 2.0) * 10 * end;
  for (const ColumnSpecies& species : column.species) {
    const double a = species.mass * 0.1 * 10 / end;
    left += 0.1 * 100 / 2 * species.mass * species.share;
    right -= 0.1 * 100 * species.mass * species.share * std::exp(-a) / (1 - std::exp(-a));
  }
  EXPECT_NEAR(left / right, 1, 1e-12);
}

TEST(Sedimentation, OfKawasakisColumn) {
  const MixedColumn column = kawasaki({{1, 1, 10}});
  EXPECT_NEAR(sedimentation_temperature(column, even_column_energy(column, 0.5)) / 0.5, 1.0962, 5e-5);
}

/// Without a lid half of the freedom's share more goes into heights: E = (1 + freedom/2) T. Without gravity worth the
/// name: E = freedom T/2 + m g h/2.
TEST(Sedimentation, HasItsLimits) {
  EXPECT_NEAR(sedimentation_temperature({{{1, 1, 1e6}}, 1, 2}, 3), 1.5, 1e-9);
  EXPECT_NEAR(sedimentation_temperature({{{1, 1, 1}}, 1e-6, 3}, 3), 2 - 1e-6 / 3, 1e-11);
}

/// A species that weighs nothing changes no temperature but takes its share of the energy of motion.
TEST(Sedimentation, OfSpeciesAlikeIsThatOfOne) {
  const double one = sedimentation_temperature({{{2, 1, 3}}, 0.7, 3}, 4);
  EXPECT_NEAR(sedimentation_temperature({{{2, 0.25, 3}, {2, 0.75, 3}}, 0.7, 3}, 4), one, 1e-13);
}

/// The twin: waves of a stratified gas, rho d2x/dt2 = d/dz(c n T dx/dz) with x = 0 at both ends (one dimension, adiabatic),
/// by power iteration on the inverse of the matrix of differences.
double slowest_frequency(const Column& column, double freedom) {
  constexpr int steps = 800;
  const double h = column.height / steps, gamma = 1 + 2 / freedom;
  const auto density = [&](double z) {
    return std::exp(-column.mass * column.gravity * z / column.temperature);
  };
  std::vector<double> x(steps + 1, 0.0), rhs(steps + 1), upper(steps + 1);
  for (int i = 1; i < steps; ++i) x[i] = std::sin(std::numbers::pi * i / steps);
  double eigenvalue = 0;
  for (int round = 0; round < 60; ++round) {
    double before = 0, after = 0;
    for (int i = 1; i < steps; ++i) rhs[i] = column.mass * density(i * h) * x[i], before += rhs[i] * x[i];
    // Thomas' algorithm for -(p x')' = rhs, p at the half steps.
    std::vector<double> y(steps + 1, 0.0);
    for (int i = 1; i < steps; ++i) {
      const double low = gamma * column.temperature * density((i - 0.5) * h) / (h * h);
      const double high = gamma * column.temperature * density((i + 0.5) * h) / (h * h);
      const double pivot = low + high - low * upper[i - 1];
      upper[i] = high / pivot;
      y[i] = (rhs[i] + low * y[i - 1]) / pivot;
    }
    for (int i = steps - 1; i > 0; --i) y[i] += upper[i] * y[i + 1];
    for (int i = 1; i < steps; ++i) after += rhs[i] * y[i];
    eigenvalue = before / after;
    const double norm = 1 / std::sqrt(after);
    for (int i = 1; i < steps; ++i) x[i] = y[i] * norm;
  }
  return std::sqrt(eigenvalue);
}

TEST(ColumnSound, IsTheSlowestWaveOfAStratifiedGas) {
  for (const double freedom : {2.0, 6.0})
    for (const Column& column : {kColumn, Column{1, 0.548, 0.1, 10}, Column{2, 0.5, 3, 1}})
      EXPECT_NEAR(column_sound_frequency(column, freedom) / slowest_frequency(column, freedom), 1, 1e-4);
}

}  // namespace
}  // namespace sandglass::law::sedimentation_test
