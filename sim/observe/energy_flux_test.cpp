#include "sim/observe/energy_flux.hpp"

#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

namespace sandglass::energy_flux_test {
namespace {

ObserverSpec bins(std::vector<std::size_t> grid) {
  ObserverSpec spec;
  spec.grid = std::move(grid);
  return spec;
}

/// Box 4 x 4 in bins of area 2; mass 2, weight 3.
TEST(EnergyFlux, OfThreeParticles) {
  TestSystem<2> system;
  system.add_cell({{{0.5, 1.5}, {1, 0}}, {{1.9, 1.1}, {3, 4}}});
  system.add_cell({{{4, 4}, {0, -2}}});
  const auto flux = EnergyFlux<2>(bins({2, 4})).measure(system.view());
  std::vector<double> expected(16, 0.0);
  expected[2] = 3 * (1 * 1 + 25 * 3) / 2.0, expected[3] = 3 * 25 * 4 / 2.0;
  expected[15] = 3 * 4 * -2 / 2.0;
  EXPECT_EQ(flux, expected);
}

/// Masses and weights of single particles, against a plain loop.
TEST(EnergyFlux, OfAMixtureWithWeights) {
  TestSystem<3> system = random_system<3>({4, 5, 6}, 200, 5);
  system.traits = {{1, 2, 0.1}, {2, 0.3, 0.2}};
  Vector<3> sum = Vector<3>::Zero();
  for (std::size_t i = 0; i < 200; ++i) {
    system.species.push_back(static_cast<std::uint8_t>(i % 2));
    system.weights.push_back(1 + static_cast<double>(i % 5));
    const Vector<3>& v = system.particles[i].velocity;
    sum += system.weights[i] * system.traits[i % 2].mass * v.squaredNorm() / 2 * v;
  }
  const auto flux = EnergyFlux<3>(bins({1, 1, 1})).measure(system.view());
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(flux[static_cast<std::size_t>(axis)], sum[axis] / 120, 1e-12 * sum.norm());
}

}  // namespace
}  // namespace sandglass::energy_flux_test
