#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/dsmc/test_crowd.hpp"

#include <gtest/gtest.h>

// Hybrid simulation Monte Carlo as a whole: what full cells keep out, and what changes nothing where none is full.

namespace sandglass::dsmc::excluded_volume_test {
namespace {

template <int D>
Parameters hybrid(double restitution = 0.8) {
  Parameters parameters = crowd_parameters<D>(restitution);
  parameters.factor.formula = contact_formula(D);
  parameters.offset.consistent = 0.3;
  return parameters;
}

template <int D>
Dsmc<D> simulation(const Parameters& parameters, double per_cell,
                   const Vector<D>& gravity = Vector<D>::Zero()) {
  const Grid<D> grid = crowd_grid<D>();
  motion::MotionParameters<D> motion;
  motion.gravity = gravity;
  motion.walled[1] = !gravity.isZero(0);
  motion.offsets = parameters.offset.any();
  Dsmc<D> dsmc(grid, parameters, motion, {});
  dsmc.assign({crowd(grid, per_cell), {}});
  return dsmc;
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

template <int D>
void expect_plain_without_full_cells() {
  Parameters point = hybrid<D>();
  point.excluded_volume = {};
  Dsmc<D> with = simulation<D>(hybrid<D>(), 1.5), without = simulation<D>(point, 1.5);
  for (std::uint64_t step = 0; step < 400; ++step) {
    with.step(0.05, step);
    without.step(0.05, step);
  }
  ASSERT_EQ(with.counters().at("cell-collisions"), 0);
  EXPECT_GT(with.tally().collisions, 100U);
  EXPECT_TRUE(std::ranges::equal(with.view().particles, without.view().particles, same<D>));
}

TEST(ExcludedVolume, ChangesNoBitWhereNoCellIsFull) {
  expect_plain_without_full_cells<2>();
  expect_plain_without_full_cells<3>();
}

/// Particles of full cells stay or leave, and nobody comes; those of the others may come in any number.
template <int D>
void expect_nobody_in_full_cells() {
  Dsmc<D> dsmc = simulation<D>(hybrid<D>(), 9);
  for (std::uint64_t step = 0; step < 30; ++step) {
    const std::vector<std::uint32_t> before(dsmc.view().offsets.begin(), dsmc.view().offsets.end());
    dsmc.step(0.2, step);
    const auto after = dsmc.view().offsets;
    for (std::size_t cell = 0; cell + 1 < before.size(); ++cell)
      if (before[cell + 1] - before[cell] >= 10) {
        ASSERT_LE(after[cell + 1] - after[cell], before[cell + 1] - before[cell]);
      }
    for (std::uint32_t cell = 0; cell + 1 < after.size(); ++cell)  // a restart would sort them alike
      for (std::uint32_t i = after[cell]; i < after[cell + 1]; ++i)
        ASSERT_EQ(crowd_grid<D>().cell_of(dsmc.view().particles[i].position), cell);
  }
  EXPECT_GT(dsmc.counters().at("moves-refused"), 1000);
}

TEST(ExcludedVolume, LetsNobodyIntoFullCells) {
  expect_nobody_in_full_cells<2>();
  expect_nobody_in_full_cells<3>();
}

/// Particles that cells have taken in above the ten that fill them, over all steps.
double taken_in_above_room(bool updated) {
  Parameters parameters = hybrid<2>();
  parameters.faults.room_updated = updated;
  Dsmc<2> dsmc = simulation<2>(parameters, 9);
  double above = 0;
  for (std::uint64_t step = 0; step < 200; ++step) {
    const std::vector<std::uint32_t> before(dsmc.view().offsets.begin(), dsmc.view().offsets.end());
    dsmc.step(0.2, step);
    const auto after = dsmc.view().offsets;
    for (std::size_t cell = 0; cell + 1 < before.size(); ++cell)
      above += std::max(0.0, static_cast<double>(after[cell + 1] - after[cell]) -
                                 std::max(10.0, static_cast<double>(before[cell + 1] - before[cell])));
  }
  return above;
}

/// The planted fault: cells that fill up in the order of work take in fewer.
TEST(ExcludedVolume, RoomIsThatOfTheStartOfTheStep) {
  EXPECT_GT(taken_in_above_room(false), 2 * taken_in_above_room(true));
}

template <int D>
void expect_conservation() {
  Dsmc<D> dsmc = simulation<D>(hybrid<D>(1), 9);
  const Vector<D> momentum_before = momentum<D>(dsmc.view().particles);
  const double energy_before = energy<D>(dsmc.view().particles);
  for (std::uint64_t step = 0; step < 100; ++step) dsmc.step(0.1, step);
  EXPECT_GT(dsmc.counters().at("cell-collisions"), 100);
  EXPECT_LT((momentum<D>(dsmc.view().particles) - momentum_before).norm(), 1e-11);
  EXPECT_NEAR(energy<D>(dsmc.view().particles) / energy_before, 1, 1e-12);
}

TEST(ExcludedVolume, ConservesMomentumAndEnergy) {
  expect_conservation<2>();
  expect_conservation<3>();
}

/// Particles in the fullest cell after a column has fallen and lost its energy.
std::uint32_t fullest_cell(const Parameters& parameters) {
  Dsmc<2> dsmc = simulation<2>(parameters, 4, {0, -1});
  for (std::uint64_t step = 0; step < 6000; ++step) dsmc.step(0.02, step);
  const auto offsets = dsmc.view().offsets;
  std::uint32_t most = 0;
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
    most = std::max(most, offsets[cell + 1] - offsets[cell]);
  return most;
}

/// 144 particles over six columns: points gather on the floor, cells that ten fill hold few more.
TEST(ExcludedVolume, HoldsUpACollapsedColumn) {
  Parameters point = hybrid<2>(0.3);
  point.excluded_volume = {};
  EXPECT_GE(fullest_cell(point), 20U);
  EXPECT_LE(fullest_cell(hybrid<2>(0.3)), 14U);
}

/// Going on from what was saved gives the same bits.
template <int D>
void expect_restart(Parameters parameters) {
  const Vector<D> gravity = -0.2 * Vector<D>::Unit(1);
  Dsmc<D> whole = simulation<D>(parameters, 8, gravity), part = simulation<D>(parameters, 8, gravity);
  for (std::uint64_t step = 0; step < 20; ++step) part.step(0.1, step);
  const View<D> view = part.view();
  Dsmc<D> resumed = simulation<D>(parameters, 8, gravity);
  resumed.assign({{view.particles.begin(), view.particles.end()}, {}});
  resumed.load(part.save());
  resumed.tally() = part.tally();
  for (std::uint64_t step = 0; step < 40; ++step) whole.step(0.1, step);
  for (std::uint64_t step = 20; step < 40; ++step) resumed.step(0.1, step);
  EXPECT_TRUE(std::ranges::equal(whole.view().particles, resumed.view().particles, same<D>));
  EXPECT_EQ(whole.counters(), resumed.counters());
}

TEST(ExcludedVolume, ResumesBitForBit) {
  Parameters ramp = hybrid<2>();
  ramp.excluded_volume.entry = {{0.4, 0.8}, {1, 0}};
  Parameters fitted = hybrid<2>();
  fitted.impact.coefficient = {{0, 2}, {0, 0.6}};
  for (const Parameters& parameters : {hybrid<2>(), ramp, fitted}) {
    expect_restart<2>(parameters);
    expect_restart<3>(parameters);
  }
}

/// One collision of two particles is one collision of each, after which the fit holds that begins before it.
TEST(FittedImpact, FollowsTheCollisionsOfEachParticle) {
  const auto pair_with = [](const Curve& coefficient) {
    Parameters parameters;
    parameters.cross_section = 0.2;
    parameters.impact.coefficient = coefficient;
    return Dsmc<2>(Grid<2>(Vector<2>(1, 1), {1, 1}), parameters, {}, {});
  };
  Dsmc<2> gas = pair_with({{0.8, 0.9}, {0, 0.7}});
  gas.assign({{{Vector<2>(0.2, 0.5), Vector<2>(1, 0)}, {Vector<2>(0.8, 0.5), Vector<2>(-1, 0)}}, {}});
  std::uint64_t step = 0;
  while (gas.tally().collisions == 0) gas.step(0.1, step++);
  ASSERT_EQ(gas.tally().collisions, 1U);
  Dsmc<2> later = pair_with({{0}, {0.7}}), earlier = pair_with({{0}, {0}});
  for (Dsmc<2>* other : {&later, &earlier}) {
    other->assign({{gas.view().particles.begin(), gas.view().particles.end()}, {}});
    other->load(gas.save());
    other->tally() = gas.tally();
  }
  for (const std::uint64_t end = step + 200; step < end; ++step)
    for (Dsmc<2>* each : {&gas, &later, &earlier}) each->step(0.1, step);
  EXPECT_TRUE(std::ranges::equal(gas.view().particles, later.view().particles, same<2>));
  EXPECT_FALSE(std::ranges::equal(gas.view().particles, earlier.view().particles, same<2>));
}

/// A cell at half the ramp lets every second particle in.
TEST(ExcludedVolume, RampAdmitsItsShare) {
  Parameters parameters = crowd_parameters<2>();
  parameters.cross_section = 0;
  parameters.excluded_volume.entry = {{0.1, 0.7}, {1, 0}};
  const std::size_t moving = 20000;
  std::vector<Phase<2>> particles(moving, {Vector<2>(0.5, 0.5), Vector<2>(1, 0)});
  for (int i = 0; i < 5; ++i) particles.push_back({Vector<2>(1.5, 0.5), Vector<2>::Zero()});
  Dsmc<2> dsmc(Grid<2>(Vector<2>(4, 1), {4, 1}), parameters, {}, {});
  dsmc.assign({particles, {}});
  dsmc.step(0.6, 0);  // the target holds 0.4: half way down the ramp
  const double refused = dsmc.counters().at("moves-refused");
  EXPECT_NEAR(refused / moving, 0.5, 4 * 0.5 / std::sqrt(moving));
  EXPECT_EQ(dsmc.view().offsets[1], refused);
}

/// Luck is drawn anew in every step: of those who wait alone half get in, then half of the rest.
TEST(ExcludedVolume, RampDrawsAnewInEveryStep) {
  Parameters parameters = crowd_parameters<2>();
  parameters.cross_section = 0;
  parameters.excluded_volume.entry = {{0.1, 0.7}, {1, 0}};
  constexpr std::uint32_t kRows = 2000;
  std::vector<Phase<2>> particles;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    particles.push_back({Vector<2>(0.5, row + 0.5), Vector<2>(1, 0)});
    for (int i = 0; i < 5; ++i) particles.push_back({Vector<2>(1.5, row + 0.5), Vector<2>::Zero()});
  }
  Dsmc<2> dsmc(Grid<2>(Vector<2>(4, kRows), {4, kRows}), parameters, {}, {});
  dsmc.assign({particles, {}});
  for (std::uint64_t step = 0; step < 2; ++step) dsmc.step(0.6, step);
  std::uint32_t waiting = 0;
  for (std::uint32_t row = 0; row < kRows; ++row)
    waiting += dsmc.view().offsets[4 * row + 1] - dsmc.view().offsets[4 * row];
  EXPECT_NEAR(waiting / double{kRows}, 0.25, 4 * std::sqrt(0.25 * 0.75 / kRows));
}

/// Pairs of particles change spins, whole cells do not.
template <int D>
void expect_rough_particles_keep_energy() {
  Parameters parameters = hybrid<D>(1);
  const double inertia = 0.1;
  parameters.kinds.species = {{1, 1, inertia}};
  parameters.kinds.surfaces = {{{1}, 1}};
  parameters.kinds.rough = true;
  motion::MotionParameters<D> motion;
  motion.offsets = true;
  Dsmc<D> dsmc(crowd_grid<D>(), parameters, motion, {}, Purpose::collisions, {column::spin<D>});
  dsmc.assign({crowd(crowd_grid<D>()), {}});
  const auto energies = [&] {
    std::pair<double, double> sum{0, 0};
    for (const Phase<D>& particle : dsmc.view().particles) sum.first += particle.velocity.squaredNorm() / 2;
    for (const Spin<D>& spin : dsmc.view().columns.get(column::spin<D>))
      sum.second += inertia * spin.squaredNorm() / 2;
    return sum;
  };
  const double before = energies().first;
  for (std::uint64_t step = 0; step < 30; ++step) dsmc.step(0.2, step);
  const auto [translation, rotation] = energies();
  EXPECT_GT(dsmc.counters().at("cell-collisions"), 100);
  EXPECT_GT(dsmc.counters().at("moves-refused"), 100);
  EXPECT_GT(rotation, 0.1 * before);
  EXPECT_NEAR((translation + rotation) / before, 1, 1e-12);
}

TEST(ExcludedVolume, RoughParticlesKeepTheirEnergy) {
  expect_rough_particles_keep_energy<2>();
  expect_rough_particles_keep_energy<3>();
}

}  // namespace
}  // namespace sandglass::dsmc::excluded_volume_test
