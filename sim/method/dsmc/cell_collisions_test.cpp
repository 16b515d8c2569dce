#include "sim/method/dsmc/cell_collisions.hpp"

#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/test_crowd.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

namespace sandglass::dsmc::cell_collisions_test {
namespace {

/// The stage by itself: nothing moves.
template <int D>
struct Bench {
  Bench(const Grid<D>& grid, const Parameters& parameters, const std::vector<Phase<D>>& particles,
        const std::array<bool, D>& periodic)
      : store(grid), full(parameters, grid), stage(parameters, grid, full), neighbours(grid, periodic) {
    store.assign({particles, {}});
    full.update(store.offsets());
  }

  void apply(std::uint64_t number) {
    const CellStep<D> step{
        StreamKey(1, Purpose::collisions, 0, number), number, 0.1, store, fields, neighbours};
    fields.update(stage.needs(step), store);
    stage.apply(step);
  }
  std::span<const Phase<D>> cell(std::uint32_t index) const {
    const auto offsets = store.offsets();
    return store.phases().subspan(offsets[index], offsets[index + 1] - offsets[index]);
  }
  std::span<const Phase<D>> all() const { return std::as_const(store).phases(); }

  ParticleStore<D> store;
  FullCells<D> full;
  CellCollisions<D> stage;
  CellFields<D> fields;
  Neighbours<D> neighbours;
};

template <int D>
std::array<bool, D> sides(bool periodic) {
  std::array<bool, D> all;
  all.fill(periodic);
  return all;
}

template <int D>
void expect_books_to_close(double restitution, bool periodic) {
  const Grid<D> grid = crowd_grid<D>();
  Bench<D> bench(grid, crowd_parameters<D>(restitution), crowd(grid), sides<D>(periodic));
  const Vector<D> momentum_before = momentum<D>(bench.all());
  const double energy_before = energy<D>(bench.all());
  for (std::uint64_t step = 0; step < 50; ++step) bench.apply(step);
  EXPECT_GT(bench.stage.count().collisions, 100);
  EXPECT_EQ(bench.stage.count().heat > 0, restitution < 1);
  EXPECT_EQ(bench.stage.count().heat_lost, 0);
  EXPECT_LT((momentum<D>(bench.all()) - momentum_before).norm(), 1e-12);
  EXPECT_NEAR(energy<D>(bench.all()) / energy_before, 1, 1e-13);
}

TEST(CellCollisions, KeepMomentumAndEnergyToRounding) {
  for (const double restitution : {0.0, 0.7, 1.0})
    for (const bool periodic : {true, false}) {
      expect_books_to_close<2>(restitution, periodic);
      expect_books_to_close<3>(restitution, periodic);
    }
}

/// Which pairs collide, the slow way: every full cell of the active colour names its fastest approach, and of those who
/// name the same cell the fastest has it.
template <int D>
std::map<std::uint32_t, std::uint32_t> pairs_by_hand(const Bench<D>& bench, bool periodic,
                                                     std::uint64_t step) {
  const Grid<D>& grid = bench.store.grid();
  const auto velocity = [&](std::uint32_t cell) {
    return Vector<D>(momentum<D>(bench.cell(cell)) / static_cast<double>(bench.cell(cell).size()));
  };
  const auto place = [&](std::uint32_t cell) {
    std::array<int, D> along;
    for (int axis = 0; axis < D; ++axis) {
      along[static_cast<std::size_t>(axis)] = static_cast<int>(cell % grid.cells(axis));
      cell /= grid.cells(axis);
    }
    return along;
  };
  std::map<std::uint32_t, std::pair<double, std::uint32_t>> best;
  for (std::uint32_t from = 0; from < grid.size(); ++from) {
    const auto a = place(from);
    int sum = 0;
    for (const int x : a) sum += x;
    if (bench.cell(from).size() < 10 || sum % 2 != static_cast<int>(step % 2)) continue;
    std::optional<std::pair<double, std::uint32_t>> mine;
    for (std::uint32_t to = 0; to < grid.size(); ++to) {
      Vector<D> apart;
      for (int axis = 0; axis < D; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const int cells = static_cast<int>(grid.cells(axis));
        int steps = place(to)[i] - a[i];
        if (periodic && std::abs(steps) == cells - 1) steps = steps > 0 ? -1 : 1;
        apart[axis] = steps;
      }
      if (apart.squaredNorm() != 1 || bench.cell(to).empty()) continue;
      const double approach = (velocity(from) - velocity(to)).dot(apart);
      if (approach > 0 && (!mine || approach > mine->first)) mine = {approach, to};
    }
    if (mine && (!best.contains(mine->second) || best[mine->second].first < mine->first))
      best[mine->second] = {mine->first, from};
  }
  std::map<std::uint32_t, std::uint32_t> pairs;
  for (const auto& [to, choice] : best) pairs[to] = choice.second;
  return pairs;
}

template <int D>
void expect_pairs_of_twin(bool periodic) {
  const Grid<D> grid = crowd_grid<D>();
  Bench<D> bench(grid, crowd_parameters<D>(), crowd(grid), sides<D>(periodic));
  for (std::uint64_t step = 0; step < 10; ++step) {
    const auto pairs = pairs_by_hand(bench, periodic, step);
    std::vector<Phase<D>> before(bench.all().begin(), bench.all().end());
    bench.apply(step);
    std::set<std::uint32_t> colliding;
    for (const auto& [to, from] : pairs) colliding.insert({to, from});
    EXPECT_EQ(colliding.size(), 2 * pairs.size());  // pairs share no cell
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
      const auto first = bench.store.offsets()[cell];
      const bool changed =
          !bench.cell(cell).empty() && bench.cell(cell)[0].velocity != before[first].velocity;
      EXPECT_EQ(changed, colliding.contains(cell)) << "step " << step << ", cell " << cell;
    }
    for (const auto& [to, from] : pairs) {  // each pair by itself closes its books
      const auto of = [&](std::uint32_t cell) {
        return std::span<const Phase<D>>(before).subspan(bench.store.offsets()[cell],
                                                         bench.cell(cell).size());
      };
      const Vector<D> was = momentum<D>(of(to)) + momentum<D>(of(from));
      EXPECT_LT((momentum<D>(bench.cell(to)) + momentum<D>(bench.cell(from)) - was).norm(), 1e-13);
      EXPECT_NEAR(energy<D>(bench.cell(to)) + energy<D>(bench.cell(from)),
                  energy<D>(of(to)) + energy<D>(of(from)), 1e-13);
    }
  }
}

TEST(CellCollisions, CollideThePairsOfTheirTwin) {
  for (const bool periodic : {true, false}) {
    expect_pairs_of_twin<2>(periodic);
    expect_pairs_of_twin<3>(periodic);
  }
}

/// With an odd number of cells around, no cell collides twice in a step, and every pair across the seam has its turns.
TEST(CellCollisions, CloseAroundAnOddNumberOfCells) {
  const Parameters parameters = crowd_parameters<2>(1);
  std::vector<Phase<2>> particles;
  for (std::uint32_t cell = 0; cell < 5; ++cell)
    for (int i = 0; i < 12; ++i) particles.push_back({Vector<2>(cell + 0.5, 0.5), Vector<2>::Zero()});
  std::set<std::uint32_t> collided;  // cells that have collided with the next one
  for (std::uint32_t cell = 0; cell < 5; ++cell)
    for (std::uint64_t step = 0; step < 10; ++step) {
      auto approaching = particles;
      for (int i = 0; i < 12; ++i) {
        approaching[12 * cell + static_cast<std::size_t>(i)].velocity[0] = 1;
        approaching[12 * ((cell + 1) % 5) + static_cast<std::size_t>(i)].velocity[0] = -1;
      }
      Bench<2> bench(Grid<2>(Vector<2>(5, 1), {5, 1}), parameters, approaching, {true, false});
      bench.apply(step);
      ASSERT_LE(bench.stage.count().collisions, 1);  // a single pair approaches
      ASSERT_LT(momentum<2>(bench.all()).norm(), 1e-13);
      if (bench.stage.count().collisions > 0) collided.insert(cell);
    }
  EXPECT_EQ(collided.size(), 5U);
}

/// Two cells side by side in a box of two; the first holds `left` particles, the second `right`.
Bench<2> two_cells(std::size_t left, std::size_t right, const Vector<2>& speed, double heat,
                   const Parameters& parameters) {
  std::vector<Phase<2>> particles;
  Random random(StreamKey(3, Purpose::velocities, 0, 0), 0);
  for (std::size_t i = 0; i < left + right; ++i) {
    const bool first = i < left;
    const Vector<2> own(heat * (random.uniform() - 0.5), heat * (random.uniform() - 0.5));
    particles.push_back({Vector<2>(first ? 0.5 : 1.5, 0.5), Vector<2>((first ? 1 : -1) * speed + own)});
  }
  return Bench<2>(Grid<2>(Vector<2>(2, 1), {2, 1}), parameters, particles, {false, false});
}

double relative_square(const Bench<2>& bench) {
  return (momentum<2>(bench.cell(0)) / static_cast<double>(bench.cell(0).size()) -
          momentum<2>(bench.cell(1)) / static_cast<double>(bench.cell(1).size()))
      .squaredNorm();
}

/// Impact parameters are uniform as between particles: with b^2 = 1/3 in the mean the normal part of the relative speed
/// keeps 2/3, so that the square of it falls to 1 - (1 - r^2) 2/3.
TEST(CellCollisions, LoseOnAverageWhatTwoDisksWould) {
  const Parameters parameters = crowd_parameters<2>(0.5);
  std::vector<double> ratios;
  for (std::uint64_t trial = 0; trial < 4000; ++trial) {
    Bench<2> bench = two_cells(12, 12, {0.5, 0.1}, 0.3, parameters);
    const double before = relative_square(bench);
    bench.apply(2 * trial);
    ratios.push_back(relative_square(bench) / before);
  }
  const Mean ratio = mean_of_independent(ratios);
  EXPECT_LT(ratio.standard_error, 0.004);
  EXPECT_NEAR(ratio.value, 1 - 0.75 * 2 / 3, 4 * ratio.standard_error);
}

TEST(CellCollisions, WaitForTheirColourAndForAnApproach) {
  const Parameters parameters = crowd_parameters<2>();
  Bench<2> receding = two_cells(12, 12, {-0.5, 0}, 0.1, parameters);
  for (std::uint64_t step = 0; step < 4; ++step) receding.apply(step);
  EXPECT_EQ(receding.stage.count().collisions, 0);
  Bench<2> right_full = two_cells(3, 12, {0.5, 0}, 0.1, parameters);
  right_full.apply(0);  // the turn of the cell that is not full
  EXPECT_EQ(right_full.stage.count().collisions, 0);
  right_full.apply(1);
  EXPECT_EQ(right_full.stage.count().collisions, 1);
  Bench<2> none_full = two_cells(3, 9, {0.5, 0}, 0.1, parameters);
  for (std::uint64_t step = 0; step < 4; ++step) none_full.apply(step);
  EXPECT_EQ(none_full.stage.count().collisions, 0);
}

double heat_of(std::span<const Phase<2>> cell) {
  const auto count = static_cast<double>(cell.size());
  return energy<2>(cell) - 0.5 * momentum<2>(cell).squaredNorm() / count;
}

/// Seen from the centre of mass a cell loses in proportion to the mass of the other, and gets back what it has lost.
TEST(CellCollisions, ShareTheHeatAsTheyLoseIt) {
  Bench<2> bench = two_cells(12, 4, {0.5, 0}, 0.1, crowd_parameters<2>(0.5));
  const double before_1 = heat_of(bench.cell(0)), before_2 = heat_of(bench.cell(1));
  bench.apply(0);
  const double heat = bench.stage.count().heat;
  EXPECT_GT(heat, 0.01);
  EXPECT_NEAR(heat_of(bench.cell(0)) - before_1, heat / 4, 1e-13);
  EXPECT_NEAR(heat_of(bench.cell(1)) - before_2, heat * 3 / 4, 1e-13);
}

/// The heat goes to the cell that can take it, and is counted where none can.
TEST(CellCollisions, GiveHeatToTheCellWithRelativeMotion) {
  const Parameters parameters = crowd_parameters<2>(0);
  Bench<2> one_alone = two_cells(12, 1, {0.5, 0}, 0.1, parameters);
  const double before = energy<2>(one_alone.all());
  one_alone.apply(0);
  EXPECT_EQ(one_alone.stage.count().heat_lost, 0);
  EXPECT_NEAR(energy<2>(one_alone.all()), before, 1e-14);
  Bench<2> frozen = two_cells(12, 12, {0.5, 0}, 0, parameters);
  const double cold = energy<2>(frozen.all());
  frozen.apply(0);
  EXPECT_GT(frozen.stage.count().heat_lost, 0);
  EXPECT_NEAR(energy<2>(frozen.all()) + frozen.stage.count().heat_lost, cold, 1e-14);
}

/// Relative motion of 1e-100 takes up all the heat: momentum keeps all the same.
TEST(CellCollisions, KeepMomentumHoweverColdTheCellsAre) {
  Bench<2> bench = two_cells(12, 12, {0.5, 0}, 1e-13, crowd_parameters<2>(0));
  const Vector<2> before = momentum<2>(bench.all());
  const double energy_before = energy<2>(bench.all());
  bench.apply(0);
  EXPECT_LT((momentum<2>(bench.all()) - before).norm(), 1e-14);
  EXPECT_NEAR(energy<2>(bench.all()), energy_before, 1e-13);
}

TEST(CellCollisions, PlantedFaultsShow) {
  Parameters kept = crowd_parameters<2>(0.5);
  kept.faults.heat_share = 0;
  Bench<2> cooled = two_cells(12, 12, {0.5, 0}, 0.1, kept);
  const double before = energy<2>(cooled.all());
  cooled.apply(0);
  EXPECT_LT(energy<2>(cooled.all()), before - 0.01);
  Parameters fixed = crowd_parameters<2>();
  fixed.faults.colours_fixed = true;
  Bench<2> right_full = two_cells(3, 12, {0.5, 0}, 0.1, fixed);
  for (std::uint64_t step = 0; step < 4; ++step) right_full.apply(step);
  EXPECT_EQ(right_full.stage.count().collisions, 0);
}

}  // namespace
}  // namespace sandglass::dsmc::cell_collisions_test
