#include "sim/space/window_sum.hpp"

#include "sim/base/random.hpp"
#include "sim/space/test_lattice.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::window_sum_test {
namespace {

struct Twin {
  double sum = 0, cells = 0;
};

template <int D>
std::array<int, D> coordinates(const Grid<D>& grid, std::uint32_t cell) {
  std::array<int, D> place;
  for (std::size_t axis = 0; axis < D; ++axis) {
    place[axis] = static_cast<int>(cell % grid.cells(static_cast<int>(axis)));
    cell /= grid.cells(static_cast<int>(axis));
  }
  return place;
}

/// The slow twin: looks at every cell of the box. A cell is in the window if it is within `half` cells along each axis,
/// the shorter way round where the axis is periodic.
template <int D>
Twin look_at_every_cell(const Grid<D>& grid, const std::array<bool, D>& periodic, int half,
                        const std::vector<std::uint32_t>& counts, std::uint32_t centre) {
  const auto here = coordinates(grid, centre);
  Twin twin;
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    const auto there = coordinates(grid, cell);
    bool inside = true;
    for (std::size_t axis = 0; axis < D; ++axis) {
      int gap = std::abs(here[axis] - there[axis]);
      if (periodic[axis]) gap = std::min(gap, static_cast<int>(grid.cells(static_cast<int>(axis))) - gap);
      inside &= gap <= half;
    }
    twin.sum += inside * static_cast<double>(counts[cell]);
    twin.cells += inside;
  }
  return twin;
}

template <int D>
void expect_twin(const std::array<std::uint32_t, D>& cells, const std::array<bool, D>& periodic,
                 double wanted) {
  const Grid<D> grid(Vector<D>::Constant(1), cells);
  Random random(StreamKey(8, Purpose::positions, 0, 0), 0);
  std::vector<std::uint32_t> counts(grid.size()), offsets{0};
  for (std::uint32_t& count : counts) {
    count = static_cast<std::uint32_t>(4 * random.uniform());
    offsets.push_back(offsets.back() + count);
  }
  WindowSum<D> window(grid, periodic, 1.5, wanted);
  for (int repeat = 0; repeat < 2; ++repeat)
    window.update(offsets);  // twice: an update leaves nothing behind
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    const Twin twin = look_at_every_cell<D>(grid, periodic, window.half_width(), counts, cell);
    ASSERT_EQ(window.sum(cell), twin.sum) << "cell " << cell << " half width " << window.half_width();
    ASSERT_EQ(window.cells(cell), twin.cells) << "cell " << cell << " half width " << window.half_width();
  }
}

constexpr double kWanted[] = {0, 1, 14, 40, 100, 1e9};

TEST(WindowSum, AgreesWithItsTwinIn2D) {
  for (double wanted : kWanted)
    for (bool x : {false, true})
      for (bool y : {false, true}) {
        expect_twin<2>({9, 12}, {x, y}, wanted);
        expect_twin<2>({1, 30}, {x, y}, wanted);
        expect_twin<2>({16, 2}, {x, y}, wanted);
      }
}

TEST(WindowSum, AgreesWithItsTwinIn3D) {
  for (double wanted : kWanted)
    for (bool x : {false, true})
      for (bool z : {false, true}) {
        expect_twin<3>({7, 6, 5}, {x, true, z}, wanted);
        expect_twin<3>({1, 3, 11}, {x, false, z}, wanted);
      }
}

/// Diagonal cells: those with their middles in the window count, and cells at walls by their part.
TEST(WindowSum, OfDiagonalCellsTakesMiddlesInTheWindow) {
  for_each_diagonal([](const LatticeOfCells<2>& lattice) {
    const std::vector<Vector<2>> middles = middles_of_diagonal(lattice);
    std::vector<std::uint32_t> offsets{0};
    for (std::uint32_t cell = 0; cell < lattice.size(); ++cell) offsets.push_back(offsets.back() + cell % 4);
    for (const double wanted : {0.0, 6.0, 20.0, 1e9}) {
      WindowSum<2> window(lattice, periodic_axes(lattice), 1.5, wanted);
      for (int repeat = 0; repeat < 2; ++repeat) window.update(offsets);
      for (std::uint32_t cell = 0; cell < lattice.size(); ++cell) {
        Twin twin;
        for (std::uint32_t other = 0; other < lattice.size(); ++other) {
          const Vector<2> way = half_diagonals(lattice, middles[other] - middles[cell]).cwiseAbs();
          if (way.maxCoeff() > window.half_width() + 1e-9) continue;
          twin.sum += other % 4;
          twin.cells += lattice.volumes().empty() ? 1 : lattice.volumes()[other];
        }
        ASSERT_EQ(window.sum(cell), twin.sum) << "cell " << cell << " half width " << window.half_width();
        ASSERT_EQ(window.cells(cell), twin.cells) << "cell " << cell << " half width " << window.half_width();
      }
    }
  });
}

/// Float sums of volumes that are no whole numbers: to their rounding.
TEST(WindowSum, FollowsTheVolumesOfShiftedCells) {
  auto lattice = LatticeOfCells<2>::shifted(Grid<2>(Vector<2>(1, 1), {9, 12}), {false, true});
  WindowSum<2> window(lattice, {false, true}, 1, 9);
  ASSERT_EQ(window.half_width(), 1);
  EXPECT_EQ(window.cells(0), 6);
  lattice.shift({0.3, 0.4});
  window.set_volumes(lattice.volumes());
  EXPECT_NEAR(window.cells(0), 3 * (1.3 + 1), 1e-5);
  EXPECT_NEAR(window.cells(4), 9, 1e-5);
  EXPECT_NEAR(window.cells(8), 3 * (1 + 0.7), 1e-5);
}

TEST(WindowSum, IsTheSmallestThatHoldsEnough) {
  const Grid<2> grid(Vector<2>(1, 1), {40, 40});
  const auto half_width = [&](double wanted) {
    return WindowSum<2>(grid, {true, true}, 2, wanted).half_width();
  };
  EXPECT_EQ(half_width(2), 0);
  EXPECT_EQ(half_width(2.1), 1);
  EXPECT_EQ(half_width(18), 1);
  EXPECT_EQ(half_width(18.1), 2);
}

}  // namespace
}  // namespace sandglass::window_sum_test
