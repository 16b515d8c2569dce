#include "sim/observe/species_density.hpp"

#include "sim/observe/fields.hpp"
#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

namespace sandglass::species_density_test {
namespace {

ObserverSpec two_by_four(std::size_t species) {
  ObserverSpec spec;
  spec.grid = {2, 4};
  spec.species.resize(species);
  return spec;
}

/// Box 4 x 4 in bins of area 2, weight 3: three particles in bin 1, one in bin 7.
TestSystem<2> four_particles() {
  TestSystem<2> system;
  system.add_cell({{{0.5, 1.5}, {1, 0}}, {{1.9, 1.1}, {3, 4}}, {{0.1, 1.9}, {0, 0}}});
  system.add_cell({{{4, 4}, {7, 8}}});
  return system;
}

TEST(SpeciesDensity, CountsEachSpeciesByItself) {
  TestSystem<2> system = four_particles();
  system.traits = {{1, 2, 0.1}, {2, 0.3, 0.2}};
  system.species = {0, 1, 1, 0};
  std::vector<double> expected(16, 0.0);
  expected[2] = 1.5, expected[3] = 3, expected[14] = 1.5;
  EXPECT_EQ(SpeciesDensity<2>(two_by_four(2)).measure(system.view()), expected);
}

TEST(SpeciesDensity, TakesTheWeightsOfTheParticles) {
  TestSystem<2> system = four_particles();
  system.traits = {{1, 2, 0.1}, {2, 0.3, 0.2}};
  system.species = {0, 1, 1, 0};
  system.weights = {1, 2, 4, 8};
  std::vector<double> expected(16, 0.0);
  expected[2] = 0.5, expected[3] = 3, expected[14] = 4;
  EXPECT_EQ(SpeciesDensity<2>(two_by_four(2)).measure(system.view()), expected);
}

/// Without a column of species all are of the first; the sum is the density of `fields`.
TEST(SpeciesDensity, OfOneSpeciesIsTheDensityOfFields) {
  TestSystem<3> system = random_system<3>({4, 5, 6}, 300, 11);
  ObserverSpec spec = two_by_four(1);
  spec.grid = {2, 3, 4};
  const auto fields = Fields<3>(spec).measure(system.view());
  const auto density = SpeciesDensity<3>(spec).measure(system.view());
  ASSERT_EQ(density.size(), 24u);
  for (std::size_t bin = 0; bin < 24; ++bin) EXPECT_EQ(density[bin], fields[5 * bin]) << bin;
}

}  // namespace
}  // namespace sandglass::species_density_test
