#include "sim/space/shared_cells.hpp"

#include "sim/base/thread_ranks.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace sandglass::shared_cells_test {
namespace {

/// Of cells that hold these numbers of particles.
std::vector<std::uint32_t> offsets_of(const std::vector<std::uint32_t>& counts) {
  std::vector<std::uint32_t> offsets{0};
  for (const std::uint32_t count : counts) offsets.push_back(offsets.back() + count);
  return offsets;
}

TEST(SharedCells, OneProcessWorksOnAll) {
  const SharedCells cells(7);
  EXPECT_EQ(cells.first(), 0u);
  EXPECT_EQ(cells.last(), 7u);
  EXPECT_EQ(cells.owner(6), 0u);
  EXPECT_FALSE(cells.shared());
}

/// Ranks without a cell among them.
TEST(SharedCells, EveryCellHasTheOwnerWhoseRangeHoldsIt) {
  on_ranks(5, [](Communicator& ranks) {
    SharedCells cells(10);
    cells.share(ranks);
    cells.set_cuts({0, 0, 3, 3, 9, 10});
    for (std::uint32_t cell = 0; cell < 10; ++cell)
      EXPECT_EQ(cells.owner(cell) == ranks.rank(), cell >= cells.first() && cell < cells.last());
  });
}

TEST(SharedCells, NumbersOfOthersComeIn) {
  on_ranks(4, [](Communicator& ranks) {
    SharedCells cells(9);
    cells.share(ranks);
    cells.set_cuts({0, 2, 2, 8, 9});
    std::vector<double> numbers(9, -1);
    for (std::uint32_t cell = cells.first(); cell < cells.last(); ++cell) numbers[cell] = 3 * cell;
    cells.complete<double>(numbers);
    for (std::uint32_t cell = 0; cell < 9; ++cell) EXPECT_EQ(numbers[cell], 3 * cell);
  });
}

TEST(EqualCuts, GiveEachRankAboutItsShare) {
  std::vector<std::uint32_t> counts(1000);
  for (std::uint32_t cell = 0; cell < 1000; ++cell) counts[cell] = cell % 7 + cell / 200;
  const auto offsets = offsets_of(counts);
  const std::uint32_t largest_cell = 10;
  for (std::size_t ranks = 1; ranks < 9; ++ranks) {
    const auto cuts = equal_cuts(offsets, ranks);
    ASSERT_EQ(cuts.size(), ranks + 1);
    EXPECT_EQ(cuts.front(), 0u);
    EXPECT_EQ(cuts.back(), 1000u);
    EXPECT_TRUE(std::is_sorted(cuts.begin(), cuts.end()));
    EXPECT_LE(largest_share(offsets, cuts), offsets.back() / ranks + largest_cell);
  }
}

TEST(EqualCuts, LeaveRanksIdleThatFindNoCell) {
  const auto cuts = equal_cuts(offsets_of({0, 50, 0}), 4);
  EXPECT_EQ(cuts.size(), 5u);
  EXPECT_TRUE(std::is_sorted(cuts.begin(), cuts.end()));
  EXPECT_EQ(largest_share(offsets_of({0, 50, 0}), cuts), 50u);
  EXPECT_EQ(equal_cuts(offsets_of({0, 0}), 3), (std::vector<std::uint32_t>{0, 0, 0, 2}));
}

}  // namespace
}  // namespace sandglass::shared_cells_test
