#include "sim/space/cell_colours.hpp"

#include "sim/space/neighbours.hpp"

#include <set>

#include <gtest/gtest.h>

namespace sandglass::cell_colours_test {
namespace {

template <int D>
std::set<std::uint32_t> around(const Neighbours<D>& neighbours, std::uint32_t cell) {
  std::set<std::uint32_t> cells;
  neighbours.for_each_around(cell, [&](std::uint32_t other) { cells.insert(other); });
  return cells;
}

/// Every cell has one colour, and no cell is around two of a colour.
template <int D>
void expect_apart(const std::array<std::uint32_t, D>& numbers, const std::array<bool, D>& periodic) {
  const Grid<D> grid(Vector<D>::Ones(), numbers);
  const Neighbours<D> neighbours(grid, periodic);
  std::set<std::uint32_t> all;
  for (const auto& colour : cell_colours<D>(grid, periodic)) {
    std::set<std::uint32_t> taken;
    for (const std::uint32_t cell : colour) {
      ASSERT_TRUE(all.insert(cell).second);
      for (const std::uint32_t other : around(neighbours, cell)) ASSERT_TRUE(taken.insert(other).second);
    }
  }
  EXPECT_EQ(all.size(), grid.size());
}

TEST(CellColours, ShareNoCellAround) {
  for (std::uint32_t cells = 1; cells < 12; ++cells)
    for (const bool periodic : {false, true}) {
      expect_apart<2>({cells, 7}, {periodic, true});
      expect_apart<2>({6, cells}, {!periodic, periodic});
      expect_apart<3>({cells, 4, 5}, {periodic, true, false});
    }
}

TEST(CellColours, AreThreeAlongAWallAndUpToFiveAlongASeam) {
  const auto colours = [](std::uint32_t cells, bool periodic) {
    return cell_colours<2>(Grid<2>({1, 1}, {cells, 1}), {periodic, false}).size();
  };
  for (std::uint32_t cells : {9u, 10u, 11u}) EXPECT_EQ(colours(cells, false), 3u);
  EXPECT_EQ(colours(9, true), 3u);
  EXPECT_EQ(colours(10, true), 4u);
  EXPECT_EQ(colours(11, true), 5u);
}

/// The cells around are those whose places differ by at most one along each axis.
TEST(Neighbours, AroundAreThoseThatTouch) {
  const Grid<3> grid({5, 4, 6}, {5, 4, 6});
  const Neighbours<3> neighbours(grid, {true, false, true});
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    std::set<std::uint32_t> expected;
    for (std::uint32_t other = 0; other < grid.size(); ++other) {
      const std::array<int, 3> apart{static_cast<int>(other % 5) - static_cast<int>(cell % 5),
                                     static_cast<int>(other / 5 % 4) - static_cast<int>(cell / 5 % 4),
                                     static_cast<int>(other / 20) - static_cast<int>(cell / 20)};
      const bool near = (std::abs(apart[0]) <= 1 || std::abs(apart[0]) == 4) && std::abs(apart[1]) <= 1 &&
                        (std::abs(apart[2]) <= 1 || std::abs(apart[2]) == 5);
      if (near) expected.insert(other);
    }
    EXPECT_EQ(around(neighbours, cell), expected);
  }
}

}  // namespace
}  // namespace sandglass::cell_colours_test
