#include "sim/method/dsmc/dsmc.hpp"

#include "sim/base/statistics.hpp"
#include "sim/observe/sums.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace sandglass::dsmc::dsmc_test {
namespace {

constexpr std::size_t kParticles = 3000;

Parameters gas(int dimension) {
  Parameters parameters;
  parameters.diameter = 0.2;
  parameters.cross_section = cross_section(dimension, 0.2);
  return parameters;
}

template <int D>
std::vector<Phase<D>> particles() {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> list(kParticles);
  for (Phase<D>& particle : list)
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = 8 * random.uniform();
      particle.velocity[axis] = 2 * random.uniform() - 1;
    }
  return list;
}

template <class T, int D>
std::array<T, D> all_axes(T value) {
  std::array<T, D> axes;
  axes.fill(value);
  return axes;
}

template <int D>
Grid<D> grid() {
  return {Vector<D>::Constant(8), all_axes<std::uint32_t, D>(8)};
}

template <int D>
Dsmc<D> simulation(const Parameters& parameters, const std::vector<ColumnInfo>& columns = {}) {
  Dsmc<D> dsmc(grid<D>(), parameters, {}, {}, Purpose::collisions, columns);
  dsmc.assign({particles<D>(), {}});
  return dsmc;
}

template <int D>
double energy(const View<D>& view) {
  return sum_particles<1>(
      view, [](const Phase<D>& particle) { return std::array{particle.velocity.squaredNorm()}; })[0];
}

template <int D>
void expect_conservation() {
  Dsmc<D> dsmc = simulation<D>(gas(D));
  const Vector<D> velocity = mean_velocity(dsmc.view());
  const double before = energy(dsmc.view());
  for (std::uint64_t step = 0; step < 200; ++step) dsmc.step(0.1, step);
  EXPECT_GT(dsmc.tally().collisions, kParticles);
  EXPECT_LT((mean_velocity(dsmc.view()) - velocity).norm(), 1e-15);
  EXPECT_NEAR(energy(dsmc.view()) / before, 1, 1e-13);
  EXPECT_EQ(dsmc.tally().moves, 200 * kParticles);
}

TEST(Dsmc, ConservesMomentumAndEnergyToRounding) {
  expect_conservation<2>();
  expect_conservation<3>();
}

/// First step: sum over pairs of each cell of weight |v_ij| sigma dt / V, times the contact factor where there is one.
template <int D>
void expect_first_step(double weight, ContactFormula formula) {
  Parameters parameters = gas(D);
  parameters.weight = weight;
  parameters.factor.formula = formula;
  Dsmc<D> dsmc = simulation<D>(parameters);
  const View<D> view = dsmc.view();
  LocalContactFactor<D> factor(parameters, grid<D>(), all_axes<bool, D>(true), kParticles);
  if (formula != nullptr) factor.update(view.offsets, all_cells(view.offsets));
  double expected = 0;
  for (std::uint32_t cell = 0; cell + 1 < view.offsets.size(); ++cell)
    for (std::uint32_t i = view.offsets[cell]; i < view.offsets[cell + 1]; ++i)
      for (std::uint32_t j = view.offsets[cell]; j < i; ++j)
        expected += (view.particles[i].velocity - view.particles[j].velocity).norm() *
                    parameters.cross_section * weight * 0.05 *
                    (formula != nullptr ? factor.values()[cell] : 1);
  std::vector<double> counts;
  for (std::uint64_t step = 0; step < 300; ++step) {
    Dsmc<D> fresh = simulation<D>(parameters);
    fresh.step(0.05, step);
    counts.push_back(static_cast<double>(fresh.tally().collisions));
  }
  const Mean mean = mean_of_independent(counts);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error) << D << "D";
}

TEST(Dsmc, CollidesAtTheRateOfKineticTheory) {
  expect_first_step<2>(1, nullptr);
  expect_first_step<3>(3, nullptr);
  expect_first_step<2>(0.25, henderson);
  expect_first_step<3>(1, carnahan_starling);
}

TEST(Dsmc, IdsTravelWithTheirParticles) {
  Parameters ghosts = gas(2);
  ghosts.cross_section = 0;  // free flight: the velocity names the particle
  Dsmc<2> dsmc = simulation<2>(ghosts, {column::id});
  const auto start = particles<2>();
  for (std::uint64_t step = 0; step < 30; ++step) dsmc.step(0.3, step);
  for (std::size_t i = 0; i < kParticles; ++i) {
    ASSERT_EQ(dsmc.view().particles[i].velocity, start[dsmc.ids()[i]].velocity);
  }
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

/// The order of the particles in their cells is part of the state, and the streams follow from the step alone.
TEST(Dsmc, GoesOnBitwiseFromItsParticles) {
  Parameters parameters = gas(3);
  parameters.factor.formula = carnahan_starling;
  parameters.offset = {0.2, 0.1};
  parameters.pair_count = PairCount::expected;
  Dsmc<3> dsmc = simulation<3>(parameters), resumed = simulation<3>(parameters);
  for (std::uint64_t step = 0; step < 10; ++step) dsmc.step(0.1, step);
  const auto half_way = dsmc.view().particles;
  resumed.assign({{half_way.begin(), half_way.end()}, {}});
  for (std::uint64_t step = 10; step < 20; ++step) {
    dsmc.step(0.1, step);
    resumed.step(0.1, step);
  }
  EXPECT_TRUE(std::ranges::equal(dsmc.view().particles, resumed.view().particles, same<3>));
}

TEST(Dsmc, FaultsChangeTheRun) {
  Parameters faulty = gas(2);
  faulty.faults.acceptance_inverted = true;
  Dsmc<2> honest = simulation<2>(gas(2)), wrong = simulation<2>(faulty);
  honest.step(0.5, 0);
  wrong.step(0.5, 0);
  EXPECT_GT(wrong.tally().collisions, honest.tally().collisions * 5 / 4);
}

}  // namespace
}  // namespace sandglass::dsmc::dsmc_test
