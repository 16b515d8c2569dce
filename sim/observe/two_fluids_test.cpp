#include "sim/observe/two_fluids.hpp"

#include "sim/observe/test_view.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::two_fluids_test {
namespace {

ObserverSpec halves() {
  ObserverSpec spec;
  spec.grid = {1, 2};
  return spec;
}

/// Box 4 x 4, weight 3: two of the first species above, one of the second below and one above.
TestSystem<2> four() {
  TestSystem<2> system;
  system.traits = {{1, 2, 0}, {1, 5, 0}};
  system.add_cell({{{1, 3}, {0, 0}}, {{2, 3.5}, {0, 0}}, {{1, 1}, {0, 0}}, {{3, 4}, {0, 0}}});
  system.species = {0, 0, 1, 1};
  return system;
}

TEST(FluidDensity, CountsTheFirstSpeciesAndAllOthersInEachBin) {
  auto system = four();
  EXPECT_EQ(FluidDensity<2>(halves()).measure(system.view()),
            (std::vector<double>{0, 3.0 / 8, 2 * 3.0 / 8, 3.0 / 8}));
}

TEST(FluidCentre, IsTheMeanPlaceOfEachFluid) {
  auto system = four();
  EXPECT_EQ(FluidCentre<2>().measure(system.view()), (std::vector<double>{1.5, 3.25, 2, 2.5}));
}

TEST(FluidCentre, CountsEveryWeight) {
  auto system = four();
  system.weights = {1, 3, 2, 2};
  EXPECT_EQ(FluidCentre<2>().measure(system.view()), (std::vector<double>{1.75, 3.375, 2, 2.5}));
}

/// By hand: p = 1/2; shares 0 of one particle and 2/3 of three: s^2 = (1/4 + 3/36)/4 = 1/12, and s_r^2 = 1/12.
TEST(MixingIndex, OfFourParticlesByHand) {
  auto system = four();
  EXPECT_NEAR(MixingIndex<2>(halves()).measure(system.view())[0], 1, 1e-15);
}

TEST(MixingIndex, IsZeroForSeparateFluids) { EXPECT_NEAR(mixing_index({{4, 0}, {0, 7}, {0, 0}}), 0, 1e-15); }
TEST(MixingIndex, IsAboveOneWhenMoreEvenThanChance) { EXPECT_GT(mixing_index({{4, 4}, {4, 4}}), 1); }
TEST(MixingIndex, IsZeroWhereItSaysNothing) {
  EXPECT_EQ(mixing_index({{1, 0}, {0, 1}}), 0);  // one particle a bin
  EXPECT_EQ(mixing_index({{3, 0}, {2, 0}}), 0);  // one fluid
  EXPECT_EQ(mixing_index({{0, 0}}), 0);
}

/// Dealt out at random over bins of unequal size the mean is 1, whatever the sizes.
TEST(MixingIndex, IsOneInTheMeanOfRandomMixtures) {
  Random random(StreamKey(1, Purpose::species, 0, 0), 0);
  constexpr int kTrials = 4000;
  double sum = 0, squares = 0;
  std::vector<int> kinds(40);
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = i < 10 ? 0 : 1;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (std::size_t last = kinds.size(); last > 1; --last)
      std::swap(kinds[last - 1],
                kinds[static_cast<std::size_t>(random.uniform() * static_cast<double>(last))]);
    std::vector<std::array<double, 2>> bins(4);
    for (std::size_t i = 0; i < kinds.size(); ++i)
      bins[i < 3 ? 0 : i < 10 ? 1 : i < 25 ? 2 : 3][static_cast<std::size_t>(kinds[i])] += 1;
    const double index = mixing_index(bins);
    sum += index;
    squares += index * index;
  }
  const double mean = sum / kTrials, error = std::sqrt((squares / kTrials - mean * mean) / kTrials);
  EXPECT_NEAR(mean, 1, 4 * error);  // wrong once in 16000 seeds
  EXPECT_LT(error, 0.01);
}

}  // namespace
}  // namespace sandglass::two_fluids_test
