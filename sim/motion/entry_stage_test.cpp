#include "sim/motion/entry_stage.hpp"

#include "sim/motion/refusable_motion.hpp"
#include "sim/motion/stream_index.hpp"
#include "sim/motion/test_flight.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

// The flight in one pass against that in two, whose rule is told the same.

namespace sandglass::motion {
namespace {

template <int D>
class SameEntries final : public EntryRule<D> {
 public:
  explicit SameEntries(const CellEntries& entries) : entries_(entries) {}
  void decide(const Proposals<D>& moves) override {
    for (std::uint32_t cell = 0; cell < moves.cells.size(); ++cell)
      for (std::uint32_t i = moves.offsets[cell]; i < moves.offsets[cell + 1]; ++i) {
        const std::uint32_t to = moves.targets[i];
        if (to == moves.cells.size() || (to == cell && !entries_.within_too)) continue;
        const double drawn = Random(entries_.key, stream_index(cell, i - moves.offsets[cell])).uniform();
        moves.refused[i] = entries_.full[to] != 0 || (to != cell && drawn >= entries_.probability[to]);
      }
    refused = static_cast<std::uint64_t>(std::ranges::count(moves.refused, 1));
  }
  std::uint64_t refused = 0;

 private:
  CellEntries entries_;
};

template <int D>
MotionParameters<D> surroundings(int which) {
  MotionParameters<D> parameters;
  if (which > 0) parameters.walled[0] = true, parameters.gravity[0] = -1;
  if (which > 1) parameters.walls = {wall<D>(0, false, {WallKind::thermal, {}, 1, 2})};
  if (which > 1) parameters.obstacles = some_obstacles<D>({WallKind::thermal});
  if (which > 2) parameters.walls.clear(), parameters.open[0] = {true, true};
  return parameters;
}

template <int D>
void expect_like_two_passes(int which, const LatticeOfCells<D>& lattice, bool within_too) {
  const auto parameters = surroundings<D>(which);
  const std::uint32_t cells = lattice.size();
  auto one = scattered<D>(2, 0, 16 * cells, lattice), two = scattered<D>(2, 0, 16 * cells, lattice);
  const auto stage = make_entry_stage<D>(parameters, box<D>());
  RefusableMotion<D> passes(parameters, box<D>());
  std::uint64_t all = 0;
  for (std::uint64_t step = 0; step < 10; ++step) {
    std::vector<std::uint8_t> full(cells + 1);
    std::vector<float> probability(cells + 1, 1);
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
      full[cell] = (cell + step) % 3 == 0;
      probability[cell] = (cell + step) % 5 == 0 ? 0.3F : 1;
    }
    const CellEntries entries{full.data(), probability.data(), wall_key(100 + step), within_too};
    const MotionStep now{0.2, 0, wall_key(step)};
    SameEntries<D> rule(entries);
    passes.advance(two, now, rule);
    one.begin_step();
    std::uint64_t refused = 0;
    for (std::uint32_t first = 0; first < cells; first += 7)
      refused += stage->advance(one, first, std::min(first + 7, cells), now, entries);
    one.sort();
    two.sort();
    ASSERT_EQ(refused, rule.refused);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one.phases()[i].position, two.phases()[i].position) << "step " << step;
      ASSERT_EQ(one.phases()[i].velocity, two.phases()[i].velocity);
    }
    all += refused;
  }
  EXPECT_GT(all, 300U);
}

TEST(EntryStage, MovesLikeTheFlightInTwoPasses) {
  for (int which = 0; which < 4; ++which) {
    expect_like_two_passes<2>(which, five_cells<2>(), false);
    expect_like_two_passes<3>(which, five_cells<3>(), false);
  }
}

TEST(EntryStage, KnowsEveryLattice) {
  for (int which = 0; which < 4; ++which) {
    const bool around = which == 0;
    auto squares = LatticeOfCells<2>::shifted(five_cells<2>(), {around, true});
    auto cubes = LatticeOfCells<3>::shifted(five_cells<3>(), {around, true, true});
    squares.shift({0.3, -0.4});
    cubes.shift({-0.2, 0.1, 0.45});
    expect_like_two_passes<2>(which, squares, true);
    expect_like_two_passes<3>(which, cubes, true);
    expect_like_two_passes<2>(which, LatticeOfCells<2>::diagonal(five_cells<2>(), {around, true}), false);
  }
}

}  // namespace
}  // namespace sandglass::motion
