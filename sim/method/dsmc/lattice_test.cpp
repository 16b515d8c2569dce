#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/dsmc/test_crowd.hpp"
#include "sim/method/dsmc/test_gas.hpp"

#include <gtest/gtest.h>

// Cells that are displaced every step, and cells that stand on a corner: rates, books, full cells and restarts are those of
// the fixed cells.

namespace sandglass::dsmc::lattice_test {
namespace {

enum class Kind { fixed, shifted, diagonal };

template <int D>
std::array<bool, D> periodic_but(int walled) {
  std::array<bool, D> periodic;
  periodic.fill(walled < D);
  if (walled < D) periodic[static_cast<std::size_t>(walled)] = false;
  return periodic;
}

/// `cells` along each axis; as many on a corner, or 2% more. Walls across one axis, or all with `walled` = D.
template <int D>
LatticeOfCells<D> lattice(Kind kind, std::uint32_t cells, double edge, int walled) {
  const Grid<D> grid = cubic_grid<D>(cells, edge);
  if (kind == Kind::shifted) return LatticeOfCells<D>::shifted(grid, periodic_but<D>(walled));
  if constexpr (D == 2)
    if (kind == Kind::diagonal) {
      const auto corners = static_cast<std::uint32_t>(std::lround(cells / M_SQRT2));
      return LatticeOfCells<D>::diagonal(Grid<D>(grid.box(), {corners, corners}), periodic_but<D>(walled));
    }
  return grid;
}

template <int D>
motion::MotionParameters<D> room(int walled, const Vector<D>& gravity = Vector<D>::Zero()) {
  motion::MotionParameters<D> motion;
  const auto periodic = periodic_but<D>(walled);
  for (std::size_t axis = 0; axis < D; ++axis) motion.walled[axis] = !periodic[axis];
  motion.gravity = gravity;
  return motion;
}

constexpr std::uint32_t kCells = 6;  // along each axis, so that most cells touch a wall
constexpr double kPerCell = 20;

/// Collisions over those of a gas of this fraction, each particle taken with the others.
template <int D>
Mean rate(const Parameters& parameters, double fraction, double contact, Kind kind) {
  const auto count = static_cast<std::size_t>(kPerCell * std::pow(kCells, D));
  Dsmc<D> dsmc(lattice<D>(kind, kCells, kCellEdge, D), parameters, room<D>(D), {});
  dsmc.assign({maxwellian<D>(count, kCells * kCellEdge), {}});
  const auto particles = static_cast<double>(count);
  const double density = fraction / particle_volume(D, 1) * (1 - 1 / particles);
  const double per_time = (D == 2 ? 2 : 4) * std::sqrt(M_PI) * density * contact, dt = 0.2 / per_time;
  std::vector<double> rates;
  for (std::uint64_t step = 0; step < (D == 2 ? 4000 : 2000); ++step) {
    const std::uint64_t before = dsmc.tally().collisions;
    dsmc.step(dt, step);
    rates.push_back(2 * static_cast<double>(dsmc.tally().collisions - before) / particles / 0.2);
  }
  return mean_of_correlated(rates);
}

/// Without offsets particles stand as chance has it. That the momentum is zero raises the mean relative speed by less than
/// 1/(2 N), which is 0.07% at most here; bounds are 4.5 standard errors.
template <int D>
void expect_rate(Kind kind) {
  Parameters point = gas_with_offset<D>(0.1, kPerCell);
  point.offset = {};
  point.factor = {};
  const Mean plain = rate<D>(point, 0.1, 1, kind);
  EXPECT_NEAR(plain.value, 1, 4.5 * plain.standard_error) << D << "D";
  EXPECT_LT(plain.standard_error, 0.002);
  Parameters expected = point;
  expected.offset.consistent = 1e-6;  // of nearly none, whose missing pairs are fast ones as a rule
  expected.pair_count = PairCount::expected;
  const Mean windowed = rate<D>(expected, 0.1, 1, kind);
  EXPECT_NEAR(windowed.value, 1, 4.5 * windowed.standard_error) << D << "D, expected pairs";
}

TEST(LatticeOfDsmc, LeavesTheRateOfKineticTheory) {
  for (const Kind kind : {Kind::fixed, Kind::shifted, Kind::diagonal}) expect_rate<2>(kind);
  for (const Kind kind : {Kind::fixed, Kind::shifted}) expect_rate<3>(kind);
}

/// The contact factor takes the density from the volume of the cells of its window.
TEST(LatticeOfDsmc, LeavesTheEnskogRate) {
  Parameters dense = gas_with_offset<2>(0.3, kPerCell);
  dense.offset = {};
  const double contact = contact_formula(2)(0.3).value;
  for (const Kind kind : {Kind::fixed, Kind::shifted, Kind::diagonal}) {
    const Mean local = rate<2>(dense, 0.3, contact, kind);
    EXPECT_NEAR(local.value, 1, 4.5 * local.standard_error);
    EXPECT_LT(local.standard_error, 0.002);
  }
}

template <int D>
Parameters hybrid(double restitution = 0.8) {
  Parameters parameters = crowd_parameters<D>(restitution);
  parameters.factor.formula = contact_formula(D);
  parameters.offset.consistent = 0.3;
  return parameters;
}

template <int D>
Dsmc<D> crowded(Kind kind, const Parameters& parameters, double per_cell = 9,
                const Vector<D>& gravity = Vector<D>::Zero()) {
  motion::MotionParameters<D> motion = room<D>(1, gravity);
  motion.offsets = parameters.offset.any();
  Dsmc<D> dsmc(lattice<D>(kind, 6, 1, 1), parameters, motion, {});
  dsmc.assign({crowd(crowd_grid<D>(), per_cell), {}});
  return dsmc;
}

template <int D>
void expect_conservation(Kind kind) {
  Dsmc<D> dsmc = crowded<D>(kind, hybrid<D>(1));
  const double before = momentum<D>(dsmc.view().particles)[0];
  const double energy_before = energy<D>(dsmc.view().particles);
  for (std::uint64_t step = 0; step < 100; ++step) dsmc.step(0.1, step);
  EXPECT_GT(dsmc.counters().at("cell-collisions"), 100);
  EXPECT_GT(dsmc.counters().at("moves-refused"), 1000);
  EXPECT_NEAR(momentum<D>(dsmc.view().particles)[0], before, 1e-11);
  EXPECT_NEAR(energy<D>(dsmc.view().particles) / energy_before, 1, 1e-12);
}

TEST(LatticeOfDsmc, KeepsTheBooksClosed) {
  expect_conservation<2>(Kind::shifted);
  expect_conservation<3>(Kind::shifted);
  expect_conservation<2>(Kind::diagonal);
}

template <int D>
std::vector<std::uint32_t> counts(const LatticeOfCells<D>& cells, std::span<const Phase<D>> particles) {
  std::vector<std::uint32_t> counts(cells.size());
  for (const Phase<D>& particle : particles) ++counts[cells.cell_of(particle.position)];
  return counts;
}

/// In the cells of the step; those at walls are full with fewer particles.
template <int D>
void expect_nobody_in_full_cells(Kind kind) {
  const Parameters parameters = hybrid<D>();
  Dsmc<D> dsmc = crowded<D>(kind, parameters);
  LatticeOfCells<D> cells = lattice<D>(kind, 6, 1, 1);
  std::size_t full = 0;
  for (std::uint64_t step = 0; step < 30; ++step) {
    if (kind == Kind::shifted) cells.shift(Eigen::Map<const Vector<D>>(dsmc.save().at("dsmc/shift").data()));
    const std::vector<std::uint32_t> before = counts<D>(cells, dsmc.view().particles);
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      ASSERT_EQ(dsmc.view().offsets[cell + 1] - dsmc.view().offsets[cell], before[cell]);
    }
    dsmc.step(0.2, step);
    const std::vector<std::uint32_t> after = counts<D>(cells, dsmc.view().particles);
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      const double volume = cells.volumes()[cell] * cells.grid().cell_volume();
      if (before[cell] < most_in_cell(D, parameters, volume)) continue;
      ASSERT_LE(after[cell], before[cell]);
      ++full;
    }
  }
  EXPECT_GT(full, 100U);
}

TEST(LatticeOfDsmc, LetsNobodyIntoFullCells) {
  expect_nobody_in_full_cells<2>(Kind::shifted);
  expect_nobody_in_full_cells<3>(Kind::shifted);
  expect_nobody_in_full_cells<2>(Kind::diagonal);
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

/// Going on from what was saved gives the same bits: the cells of the coming step are saved too.
template <int D>
void expect_restart(Kind kind, const Parameters& parameters) {
  const Vector<D> gravity = -0.2 * Vector<D>::Unit(1);
  Dsmc<D> whole = crowded<D>(kind, parameters, 8, gravity), part = crowded<D>(kind, parameters, 8, gravity);
  for (std::uint64_t step = 0; step < 20; ++step) part.step(0.1, step);
  const View<D> view = part.view();
  Dsmc<D> resumed = crowded<D>(kind, parameters, 8, gravity);
  resumed.restore({{view.particles.begin(), view.particles.end()}, {}}, part.save());
  resumed.tally() = part.tally();
  for (std::uint64_t step = 0; step < 40; ++step) whole.step(0.1, step);
  for (std::uint64_t step = 20; step < 40; ++step) resumed.step(0.1, step);
  EXPECT_TRUE(std::ranges::equal(whole.view().particles, resumed.view().particles, same<D>));
  EXPECT_EQ(whole.counters(), resumed.counters());
}

TEST(LatticeOfDsmc, ResumesBitForBit) {
  Parameters ramp = hybrid<2>(), point = hybrid<2>();
  ramp.excluded_volume.entry = {{0.4, 0.8}, {1, 0}};
  point.excluded_volume = {};
  for (const Parameters& parameters : {hybrid<2>(), ramp, point}) {
    expect_restart<2>(Kind::shifted, parameters);
    expect_restart<2>(Kind::diagonal, parameters);
    expect_restart<3>(Kind::shifted, parameters);
  }
}

/// Mean heights of a column that has fallen and lost its energy, the second 28 times later than it takes to fall by a cell.
std::pair<double, double> heights(Kind kind, const Parameters& parameters) {
  Dsmc<2> dsmc = crowded<2>(kind, parameters, 4, {0, -1});
  std::uint64_t step = 0;
  const auto height_after = [&](std::uint64_t last) {
    while (step < last) dsmc.step(0.02, step++);
    double sum = 0;
    for (const Phase<2>& particle : dsmc.view().particles) sum += particle.position[1];
    return sum / static_cast<double>(dsmc.size());
  };
  const double early = height_after(6000);
  return {early, height_after(8000)};
}

/// Points that no offset lifts end on the floor. Displaced cells hold the column lower: at the floor they are up to half as high again.
TEST(LatticeOfDsmc, HoldsUpACollapsedColumn) {
  Parameters point = hybrid<2>(0.3);
  point.excluded_volume = {};
  point.offset = {};
  const double fixed = heights(Kind::fixed, hybrid<2>(0.3)).second;
  for (const Kind kind : {Kind::shifted, Kind::diagonal}) {
    EXPECT_LT(heights(kind, point).second, 0.05 * fixed);
    const auto [early, late] = heights(kind, hybrid<2>(0.3));
    EXPECT_GT(late, 0.5 * fixed);
    EXPECT_GT(late, 0.97 * early);
  }
}

}  // namespace
}  // namespace sandglass::dsmc::lattice_test
