#include "sim/observe/kinetic_stress.hpp"

#include "sim/observe/fields.hpp"
#include "sim/observe/test_view.hpp"

#include <gtest/gtest.h>

namespace sandglass::kinetic_stress_test {
namespace {

ObserverSpec grid(std::vector<std::size_t> extents) {
  ObserverSpec spec;
  spec.grid = std::move(extents);
  return spec;
}

/// Box 4 x 4 in 2 x 1 bins of area 8; mass 2, weight 3. Relative velocities +-(1, 2), one degree of freedom: the
/// temperatures are 2 (1 + 1), 2 (2 + 2) and 2 (4 + 4), and 6 real particles per area 8.
TEST(KineticStress, OfTwoParticles) {
  TestSystem<2> system;
  system.add_cell({{{0.5, 1.5}, {1, 0}}, {{1.9, 3.1}, {3, 4}}});
  system.add_cell({{{4, 4}, {7, 8}}});
  const auto values = KineticStress<2>(grid({2, 1})).measure(system.view());
  EXPECT_EQ(values, (std::vector<double>{3, 6, 12, 0, 0, 0}));
}

/// Independent form: the trace is D n T of Fields, for weights and for mixtures too.
template <int D>
void expect_trace(bool mixture, bool weighted) {
  auto system = random_system<D>(Vector<D>::Constant(4), 200, 2);
  Random random(StreamKey(1, Purpose::species, 0, 0), 0);
  system.traits = {{1, 2, 0}, {1, 0.3, 0}};
  for (std::size_t i = 0; i < 200; ++i) {
    if (mixture) system.species.push_back(random.uniform() < 0.4);
    if (weighted) system.weights.push_back(0.5 + random.uniform());
  }
  std::vector<std::size_t> extents(D, 1);
  extents[1] = 3;
  const auto stress = KineticStress<D>(grid(extents)).measure(system.view());
  const auto fields = Fields<D>(grid(extents)).measure(system.view());
  constexpr std::size_t components = D * (D + 1) / 2;
  for (std::size_t bin = 0; bin < 3; ++bin) {
    const double* p = stress.data() + bin * components;
    const double trace = D == 2 ? p[0] + p[2] : p[0] + p[3] + p[5];
    const double expected = D * fields[bin * (D + 2)] * fields[bin * (D + 2) + D + 1];
    EXPECT_NEAR(trace, expected, 1e-12 * expected);
  }
}

TEST(KineticStress, HasTheTraceOfTheTemperature) {
  for (bool mixture : {false, true})
    for (bool weighted : {false, true}) {
      expect_trace<2>(mixture, weighted);
      expect_trace<3>(mixture, weighted);
    }
}

/// In a frame turned about z the tensor turns with it: P' = R P R^T.
TEST(KineticStress, TurnsWithTheFrame) {
  auto system = random_system<3>(Vector<3>::Constant(4), 100, 4);
  const auto tensor = [&system] {
    const auto p = KineticStress<3>(grid({1, 1, 1})).measure(system.view());
    Eigen::Matrix3d full;
    full << p[0], p[1], p[2], p[1], p[3], p[4], p[2], p[4], p[5];
    return full;
  };
  const Eigen::Matrix3d before = tensor();
  Eigen::Matrix3d turn;
  turn << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  for (Phase<3>& particle : system.particles)
    particle.velocity = turn * particle.velocity + Vector<3>(7, 8, 9);
  EXPECT_LT((tensor() - turn * before * turn.transpose()).norm(), 1e-12 * before.norm());
}

}  // namespace
}  // namespace sandglass::kinetic_stress_test
