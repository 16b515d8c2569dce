#include "sim/method/dsmc/mixture_factor.hpp"

#include "sim/base/random.hpp"
#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/local_factor.hpp"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace sandglass::dsmc::mixture_factor_test {
namespace {

template <int D>
Grid<D> many_cells() {
  if constexpr (D == 2) return {Vector<2>(60, 60), {60, 60}};
  if constexpr (D == 3) return {Vector<3>(16, 16, 16), {16, 16, 16}};
}

template <int D>
std::array<bool, D> all_periodic() {
  std::array<bool, D> periodic;
  periodic.fill(true);
  return periodic;
}

/// One large particle in so many, dropped at random into cells of volume one.
struct Dropped {
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint8_t> species;
};

Dropped drop(std::uint32_t particles, std::uint32_t cells, std::uint64_t number,
             std::uint32_t one_large_in = 3) {
  Random random(StreamKey(9, Purpose::positions, 0, number), 0);
  std::vector<std::vector<std::uint8_t>> held(cells);
  for (std::uint32_t i = 0; i < particles; ++i)
    held[static_cast<std::size_t>(cells * random.uniform())].push_back(i % one_large_in == 0);
  Dropped all;
  for (const auto& cell : held) {
    all.species.insert(all.species.end(), cell.begin(), cell.end());
    all.offsets.push_back(static_cast<std::uint32_t>(all.species.size()));
  }
  return all;
}

/// `per_cell` particles a cell are this fraction of area or volume.
template <int D>
Parameters mixture(double diameter_2, double fraction, double per_cell) {
  Parameters parameters;
  parameters.kinds.species = {{1, 1}, {diameter_2, 1}};
  parameters.factor = {contact_formula(D), true, D};
  const double mean = (2 * particle_volume(D, 1) + particle_volume(D, diameter_2)) / 3;
  parameters.weight = fraction / per_cell / mean;
  return parameters;
}

/// Two species alike are one.
template <int D>
void expect_one_species() {
  const Grid<D> grid = many_cells<D>();
  const Parameters parameters = mixture<D>(1, 0.2, 5);
  MixtureContactFactor<D> two(parameters, grid, all_periodic<D>(), 5.0 * grid.size());
  LocalContactFactor<D> one(parameters, grid, all_periodic<D>(), 5.0 * grid.size());
  const Dropped dropped = drop(5 * grid.size(), grid.size(), 0);
  two.update(dropped.offsets, all_cells(dropped.offsets), dropped.species.data());
  one.update(dropped.offsets, all_cells(dropped.offsets));
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    if (dropped.offsets[cell + 1] - dropped.offsets[cell] < 2) continue;
    ASSERT_NEAR(two.values()[cell], one.values()[cell], 1e-12);
    for (std::size_t pair = 0; pair < 4; ++pair) ASSERT_NEAR(two.shares()[4 * cell + pair], 1, 1e-12);
  }
}

TEST(MixtureContactFactor, OfAlikeSpeciesIsThatOfOne) {
  expect_one_species<2>();
  expect_one_species<3>();
}

/// Rate of each pair of species over that at the mean density; the scatter of the counts is divided out.
template <int D>
void expect_no_bias(double per_cell) {
  const Grid<D> grid = many_cells<D>();
  const Parameters parameters = mixture<D>(2, D == 2 ? 0.25 : 0.2, per_cell);
  MixtureContactFactor<D> factor(parameters, grid, all_periodic<D>(), per_cell * grid.size());
  std::array<std::vector<double>, 4> ratios;
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Dropped dropped = drop(static_cast<std::uint32_t>(per_cell * grid.size()), grid.size(), number);
    factor.update(dropped.offsets, all_cells(dropped.offsets), dropped.species.data());
    std::array<double, 4> with{}, without{};
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell)
      for (std::uint32_t i = dropped.offsets[cell]; i < dropped.offsets[cell + 1]; ++i)
        for (std::uint32_t j = dropped.offsets[cell]; j < i; ++j) {
          const std::size_t pair = dropped.species[i] * 2u + dropped.species[j];
          without[pair] += 1;
          with[pair] += factor.values()[cell] * factor.shares()[4 * cell + pair];
        }
    for (std::size_t pair = 0; pair < 4; ++pair) ratios[pair].push_back(with[pair] / without[pair]);
  }
  const Crowding mean =
      (crowding_of(D, 1) * (2.0 / 3) + crowding_of(D, 2) * (1.0 / 3)) * (parameters.weight * per_cell);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) {
      const Mean rate = mean_of_independent(ratios[2 * a + b]);
      const double expected =
          MixtureContactValue(D, mean, 1 + static_cast<double>(a), 1 + static_cast<double>(b)).value();
      std::printf("%dD, %2g per cell, pair %zu%zu: bias %+.5f +- %.5f\n", D, per_cell, a, b,
                  rate.value / expected - 1, rate.standard_error / expected);
      EXPECT_LT(rate.standard_error, 0.0005 * expected);
      EXPECT_LT(std::abs(rate.value / expected - 1), 0.0015);
    }
}

TEST(MixtureContactFactor, HasNoBias) {
  for (double per_cell : {3.0, 10.0}) {
    expect_no_bias<2>(per_cell);
    expect_no_bias<3>(per_cell);
  }
}

TEST(MixtureContactFactor, StaysFiniteBeyondClosePacking) {
  const Grid<3> grid(Vector<3>(4, 4, 4), {4, 4, 4});
  MixtureContactFactor<3> factor(mixture<3>(1000, 0.2, 2), grid, all_periodic<3>(), 128);
  std::vector<std::uint32_t> offsets(grid.size() + 1, 10'000);
  offsets[0] = 0;
  const std::vector<std::uint8_t> species(10'000, 1);
  factor.update(offsets, all_cells(offsets), species.data());
  EXPECT_TRUE(std::isfinite(factor.values()[0]));
  EXPECT_GE(factor.values()[0], 0);
}

TEST(MixtureContactFactor, FaultGivesAllPairsTheLargest) {
  const Grid<2> grid = many_cells<2>();
  Parameters parameters = mixture<2>(2, 0.25, 10);
  parameters.faults.contact_of_largest = true;
  MixtureContactFactor<2> factor(parameters, grid, all_periodic<2>(), 10.0 * grid.size());
  const Dropped dropped = drop(10 * grid.size(), grid.size(), 0);
  factor.update(dropped.offsets, all_cells(dropped.offsets), dropped.species.data());
  for (std::size_t pair = 0; pair < 4; ++pair) EXPECT_EQ(factor.shares()[pair], 1);
}

/// Ordered pairs of two species times their factor, over those that chance puts into a cell, less one.
template <int D>
Mean bias_of_expected(std::uint8_t first, std::uint8_t second, std::uint32_t one_large_in) {
  Parameters parameters = mixture<D>(2, 0.2, 4);
  parameters.factor = {};
  parameters.pair_count = PairCount::expected;
  parameters.offset.consistent = 1;
  const Grid<D> grid = many_cells<D>();
  const std::uint32_t cells = grid.size(), particles = 4 * cells;
  MixtureContactFactor<D> factor(parameters, grid, all_periodic<D>(), particles);
  const double large = std::ceil(particles / static_cast<double>(one_large_in));
  const std::array<double, 2> number{particles - large, large};
  const double by_chance = number[first] * (number[second] - (first == second)) / cells;
  std::vector<double> biases;
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    const Dropped all = drop(particles, cells, draw, one_large_in);
    factor.update(all.offsets, all_cells(all.offsets), all.species.data());
    double sum = 0;
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
      std::array<double, 2> held{};
      for (std::uint32_t i = all.offsets[cell]; i < all.offsets[cell + 1]; ++i) ++held[all.species[i]];
      sum += held[first] * (held[second] - (first == second)) * factor.values()[cell] *
             factor.shares()[4 * cell + 2 * first + second];
    }
    biases.push_back(sum / by_chance - 1);
  }
  return mean_of_independent(biases);
}

/// Exact for common species. Of rare ones the pairs of all say how many are missing, here none: 4.5 standard errors.
TEST(MixtureContactFactor, ExpectsThePairsOfChance) {
  for (const auto& [first, second] : {std::array<std::uint8_t, 2>{0, 0}, {0, 1}, {1, 1}})
    for (const std::uint32_t one_large_in : {3u, 50u})
      for (const Mean& bias : {bias_of_expected<2>(first, second, one_large_in),
                               bias_of_expected<3>(first, second, one_large_in)}) {
        const bool rare = first == 1 && second == 1 && one_large_in == 50;
        EXPECT_LT(bias.standard_error, rare ? 0.06 : 0.01);
        EXPECT_NEAR(bias.value, 0, 0.002 + 4.5 * bias.standard_error)
            << int{first} << int{second} << ", one in " << one_large_in;
      }
}

}  // namespace
}  // namespace sandglass::dsmc::mixture_factor_test
