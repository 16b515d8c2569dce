#include "sim/space/neighbours.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::neighbours_test {
namespace {

Grid<3> grid() { return {Vector<3>(4, 3, 5), {4, 3, 5}}; }

/// Twin: the cell that holds the middle of this one, shifted by one cell and wrapped.
std::optional<std::uint32_t> by_position(const Vector<3>& middle, int axis, bool up, bool periodic) {
  Vector<3> shifted = middle;
  shifted[axis] += up ? 1 : -1;
  const double length = grid().box()[axis];
  if (shifted[axis] < 0 || shifted[axis] > length) {
    if (!periodic) return std::nullopt;
    shifted[axis] += up ? -length : length;
  }
  return grid().cell_of(shifted);
}

TEST(Neighbours, AreTheCellsBesideThis) {
  const std::array<bool, 3> periodic{true, false, true};
  const Neighbours<3> neighbours(grid(), periodic);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 5; ++z) {
        const Vector<3> middle(x + 0.5, y + 0.5, z + 0.5);
        for (int axis = 0; axis < 3; ++axis)
          for (bool up : {false, true})
            EXPECT_EQ(neighbours.neighbour(grid().cell_of(middle), axis, up),
                      by_position(middle, axis, up, periodic[static_cast<std::size_t>(axis)]));
      }
}

using Pairs = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

/// Pairs along one axis; in no colour has a cell two partners.
Pairs pairs_along(const Neighbours<3>& neighbours, int axis) {
  Pairs pairs;
  for (int colour = 0; colour < neighbours.colours(axis); ++colour) {
    std::set<std::uint32_t> taken;
    neighbours.for_each_pair(axis, colour, [&](std::uint32_t low, std::uint32_t high) {
      EXPECT_TRUE(taken.insert(low).second);
      EXPECT_TRUE(taken.insert(high).second);
      EXPECT_EQ(neighbours.neighbour(low, axis, true), high);
      ++pairs[{low, high}];
    });
  }
  return pairs;
}

TEST(Neighbours, CheckerboardHasEveryPairOnce) {
  const Neighbours<3> periodic(grid(), {true, true, true}), walled(grid(), {false, false, false});
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t cells = grid().cells(axis), lines = grid().size() / cells;
    EXPECT_EQ(periodic.colours(axis), cells % 2 == 1 ? 3 : 2);
    EXPECT_EQ(walled.colours(axis), 2);
    const Pairs around = pairs_along(periodic, axis), between = pairs_along(walled, axis);
    EXPECT_EQ(around.size(), lines * cells);
    EXPECT_EQ(between.size(), lines * (cells - 1));
    for (const auto& [pair, count] : around) EXPECT_EQ(count, 1);
  }
}

TEST(Neighbours, AlternateWhereNoneHasTheSameColour) {
  for (std::uint32_t cells = 1; cells < 7; ++cells)
    for (const bool around : {false, true}) {
      const Grid<2> rectangle(Vector<2>(1, 1), {4, cells});
      const Neighbours<2> neighbours(rectangle, {true, around});
      int alike = 0;
      for (std::uint32_t cell = 0; cell < rectangle.size(); ++cell)
        neighbours.for_each_neighbour(cell, [&](std::uint32_t other, int, bool) {
          for (const std::uint64_t turn : {0, 1, 2, 3})
            alike += neighbours.colour(cell, turn) == neighbours.colour(other, turn);
        });
      EXPECT_EQ(neighbours.alternate(), alike == 0) << cells << " cells";
    }
}

/// With an odd number of cells around too: who has had no turn has the next.
TEST(Neighbours, CheckerboardSwapsWithEveryTurn) {
  for (const bool around : {true, false}) {
    const Neighbours<3> neighbours(grid(), {around, around, around});
    for (std::uint64_t turn = 0; turn < 60; turn += 2)
      for (std::uint32_t cell = 0; cell < grid().size(); ++cell)
        ASSERT_NE(neighbours.colour(cell, turn), neighbours.colour(cell, turn + 1)) << cell << ' ' << turn;
  }
}

/// In the order of the cells, and each once; rows of odd and even numbers of cells.
TEST(Neighbours, CellsOfAColourAreThoseThatHaveIt) {
  for (const bool around : {true, false})
    for (std::uint32_t row = 1; row < 6; ++row) {
      const Grid<3> box(Vector<3>(1, 1, 1), {row, 3, 2});
      const Neighbours<3> neighbours(box, {around, around, false});
      for (std::uint64_t turn = 0; turn < 30; ++turn)
        for (const std::uint32_t colour : {0U, 1U}) {
          std::vector<std::uint32_t> visited, expected;
          neighbours.for_each_of_colour(colour, turn, [&](std::uint32_t cell) { visited.push_back(cell); });
          for (std::uint32_t cell = 0; cell < box.size(); ++cell)
            if (neighbours.colour(cell, turn) == colour) expected.push_back(cell);
          ASSERT_EQ(visited, expected) << row << " cells, turn " << turn;
        }
    }
}

TEST(Neighbours, ASingleCellHasNoPair) {
  const Neighbours<2> neighbours(Grid<2>(Vector<2>(1, 1), {1, 1}), {true, false});
  EXPECT_EQ(neighbours.neighbour(0, 0, true), 0u);
  EXPECT_EQ(neighbours.neighbour(0, 1, true), std::nullopt);
  for (int axis : {0, 1})
    for (int colour = 0; colour < neighbours.colours(axis); ++colour)
      neighbours.for_each_pair(axis, colour, [](std::uint32_t, std::uint32_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace sandglass::neighbours_test
