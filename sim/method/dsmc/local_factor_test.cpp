#include "sim/method/dsmc/local_factor.hpp"

#include "sim/base/random.hpp"
#include "sim/base/statistics.hpp"

#include <cmath>
#include <cstdio>
#include <numeric>

#include <gtest/gtest.h>

// An ideal gas has Poisson counts of mean lambda in its cells (nearly, for N is fixed), and <N (N - 1) g> should be lambda^2 g(lambda): the rate of
// collisions at the mean density.

namespace sandglass::dsmc::local_factor_test {
namespace {

template <int D>
constexpr double kFraction = D == 2 ? 0.25 : 0.2;

template <int D>
Grid<D> many_cells() {
  if constexpr (D == 2) return {Vector<2>(120, 120), {120, 120}};
  if constexpr (D == 3) return {Vector<3>(24, 24, 24), {24, 24, 24}};
}

/// Parameters at which `lambda` particles in a cell of volume one are the area or volume fraction wanted.
template <int D>
Parameters parameters_of(double lambda, bool smoothed) {
  Parameters parameters;
  parameters.weight = kFraction<D> / lambda / (D == 2 ? M_PI / 4 : M_PI / 6);
  parameters.factor = {contact_formula(D), smoothed};
  return parameters;
}

/// Particles dropped at random: offsets of the cells.
std::vector<std::uint32_t> drop(std::uint32_t particles, std::uint32_t cells, Random& random) {
  std::vector<std::uint32_t> offsets(cells + 1);
  for (std::uint32_t i = 0; i < particles; ++i)
    ++offsets[1 + static_cast<std::size_t>(cells * random.uniform())];
  std::inclusive_scan(offsets.begin(), offsets.end(), offsets.begin());
  return offsets;
}

/// <N (N - 1) g> / (lambda^2 g(lambda)) - 1. Dividing by the counted <N (N - 1)> instead of lambda^2, its exact mean, takes
/// the scatter of the counts out.
template <int D>
Mean bias(double lambda, bool smoothed, bool periodic) {
  const Grid<D> grid = many_cells<D>();
  std::array<bool, D> axes;
  axes.fill(periodic);
  LocalContactFactor<D> factor(parameters_of<D>(lambda, smoothed), grid, axes, lambda * grid.size());
  std::vector<double> ratios;
  for (std::uint64_t draw = 0; draw < 60; ++draw) {
    Random random(StreamKey(9, Purpose::positions, 0, draw), 0);
    const auto offsets = drop(static_cast<std::uint32_t>(lambda * grid.size()), grid.size(), random);
    factor.update(offsets, all_cells(offsets));
    double with_factor = 0, without = 0;
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
      const double count = offsets[cell + 1] - offsets[cell];
      with_factor += count * (count - 1) * factor.values()[cell];
      without += count * (count - 1);
    }
    ratios.push_back(with_factor / without / contact_formula(D)(kFraction<D>).value - 1);
  }
  return mean_of_independent(ratios);
}

template <int D>
void expect_no_bias(double lambda) {
  const Mean own = bias<D>(lambda, false, true), smoothed = bias<D>(lambda, true, true),
             walled = bias<D>(lambda, true, false);
  std::printf(
      "%dD, %2g per cell: bias of the rate from the cell's own count %+.4f, smoothed %+.5f +- %.5f, between "
      "walls %+.5f\n",
      D, lambda, own.value, smoothed.value, smoothed.standard_error, walled.value);
  EXPECT_LT(smoothed.standard_error, 0.0002);
  EXPECT_LT(std::abs(smoothed.value), 0.001);
  EXPECT_LT(std::abs(walled.value), 0.001);
  EXPECT_GT(own.value, 0.03);
}

TEST(LocalContactFactor, SmoothedRateHasNoBias) {
  for (double lambda : {2.0, 5.0, 10.0}) {
    expect_no_bias<2>(lambda);
    expect_no_bias<3>(lambda);
  }
}

/// Uniform counts, far from zero: the factor is the formula at the density without the pair, less the variance's share.
TEST(LocalContactFactor, OfUniformCountsIsTheFormula) {
  const Grid<2> grid(Vector<2>(50, 50), {50, 50});
  std::vector<std::uint32_t> offsets{0};
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) offsets.push_back(offsets.back() + 4);
  LocalContactFactor<2> smoothed(parameters_of<2>(4, true), grid, {true, true}, 4.0 * grid.size());
  LocalContactFactor<2> own(parameters_of<2>(4, false), grid, {true, true}, 4.0 * grid.size());
  smoothed.update(offsets, all_cells(offsets));
  own.update(offsets, all_cells(offsets));
  const double quantum = 0.25 / 4 / 25, fraction = (100 - 2) * quantum;  // a window of 5 x 5 cells
  const ContactValue contact = henderson(fraction);
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    ASSERT_NEAR(smoothed.values()[cell], contact.value - 0.5 * contact.second_derivative * fraction * quantum,
                1e-12);
    ASSERT_NEAR(own.values()[cell], henderson(0.25).value, 1e-12);
  }
}

/// A density that rises evenly from a wall: right where the window is whole, that of a place half as many cells further
/// in as the wall has cut from the window elsewhere.
TEST(LocalContactFactor, OfARisingDensityIsThatOfTheMiddleOfTheWindow) {
  const Grid<2> grid(Vector<2>(6, 20), {6, 20});
  constexpr std::uint32_t kWidth = 7;
  Parameters parameters = parameters_of<2>(40, true);
  parameters.factor.window = kWidth;
  std::vector<std::uint32_t> offsets{0};
  for (std::uint32_t row = 0; row < 20; ++row)
    for (std::uint32_t cell = 0; cell < 6; ++cell) offsets.push_back(offsets.back() + 20 + 2 * row);
  LocalContactFactor<2> factor(parameters, grid, {true, false}, 1);
  factor.update(offsets, all_cells(offsets));
  const double particle = kFraction<2> / 40;
  for (std::uint32_t row = 0; row < 16; ++row) {
    const double cut = row < kWidth / 2 ? kWidth / 2 - row : 0;
    const double cells = 6 * (kWidth - cut), density = 20 + 2 * (row + cut / 2);
    const double quantum = particle / cells, fraction = density * particle - 2 * quantum;
    const ContactValue contact = henderson(fraction);
    ASSERT_NEAR(factor.values()[6 * row],
                contact.value - 0.5 * contact.second_derivative * fraction * quantum, 1e-12)
        << row;
  }
}

/// Everything in one cell: denser than any packing, where the formulas run away.
TEST(LocalContactFactor, StaysFiniteBeyondClosePacking) {
  for (bool smoothed : {false, true}) {
    const Grid<3> grid(Vector<3>(4, 4, 4), {4, 4, 4});
    std::vector<std::uint32_t> offsets(grid.size() + 1, 100'000);
    offsets[0] = 0;
    LocalContactFactor<3> factor(parameters_of<3>(2, smoothed), grid, {true, true, true}, 128);
    factor.update(offsets, all_cells(offsets));
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
      ASSERT_TRUE(std::isfinite(factor.values()[cell]));
      ASSERT_GE(factor.values()[cell], 0);
    }
  }
}

/// Cells of equal numbers: a full one has the contact value of just that density, the others lose what chance would add.
TEST(LocalContactFactor, OfFullCellsIsThatOfTheirDensity) {
  const Grid<2> grid = many_cells<2>();
  LocalContactFactor<2> factor(parameters_of<2>(10, true), grid, {true, true}, 10.0 * grid.size());
  std::vector<std::uint32_t> offsets(grid.size() + 1);
  for (std::uint32_t cell = 0; cell <= grid.size(); ++cell) offsets[cell] = 10 * cell;
  std::vector<std::uint8_t> full(grid.size());
  full[7] = 1;
  factor.update(offsets, all_cells(offsets), full.data());
  const double expected = henderson(kFraction<2>).value;
  EXPECT_NEAR(factor.values()[7], expected, 1e-12 * expected);
  EXPECT_LT(factor.values()[8], 0.995 * expected);
}

}  // namespace
}  // namespace sandglass::dsmc::local_factor_test
