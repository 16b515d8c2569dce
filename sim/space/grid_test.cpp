#include "sim/space/grid.hpp"

#include "sim/base/random.hpp"
#include "sim/space/cell_locator.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::grid_test {
namespace {

template <int D>
Grid<D> odd_grid();
template <>
Grid<2> odd_grid() {
  return {Vector<2>(4.9, 10.0 / 3), {49, 7}};
}
template <>
Grid<3> odd_grid() {
  return {Vector<3>(4.9, 10.0 / 3, 0.7), {49, 7, 3}};
}

/// Random points, and every corner of every cell with its neighbours in floating point.
template <int D>
std::vector<double> coordinates(const Grid<D>& grid, int axis) {
  const double length = grid.box()[axis];
  std::vector<double> values{0, length, std::nextafter(length, 0)};
  for (std::uint32_t i = 1; i < grid.cells(axis); ++i) {
    const double edge = length * i / grid.cells(axis);
    values.insert(values.end(), {std::nextafter(edge, 0), edge, std::nextafter(edge, length)});
  }
  Random random(StreamKey(1, Purpose::positions, 0, 0), static_cast<std::uint64_t>(axis));
  for (int i = 0; i < 30; ++i) values.push_back(length * random.uniform());
  return values;
}

template <int D>
std::vector<Vector<D>> points(const Grid<D>& grid) {
  std::vector<Vector<D>> list{Vector<D>::Zero()};
  for (int axis = 0; axis < D; ++axis) {
    std::vector<Vector<D>> longer;
    for (const Vector<D>& point : list)
      for (double x : coordinates(grid, axis)) {
        longer.push_back(point);
        longer.back()[axis] = x;
      }
    list = std::move(longer);
  }
  return list;
}

template <int D>
void expect_locator_is_grid() {
  const Grid<D> grid = odd_grid<D>();
  const CellLocator<D> locator(grid);
  for (const Vector<D>& point : points(grid))
    for (double rest : {0.0, -1e300, HUGE_VAL})
      ASSERT_EQ(locator.cell_of(Lanes<D>::from(point, rest)), grid.cell_of(point)) << point.transpose();
}

TEST(CellLocator, AgreesWithTheGrid) {
  expect_locator_is_grid<2>();
  expect_locator_is_grid<3>();
}

/// Within rounding at an edge, a point may be counted on either side.
template <int D>
void expect_point_in_its_cell() {
  const Grid<D> grid = odd_grid<D>();
  for (const Vector<D>& point : points(grid)) {
    std::uint32_t cell = grid.cell_of(point);
    ASSERT_LT(cell, grid.size());
    for (int axis = 0; axis < D; ++axis, cell /= grid.cells(axis - 1)) {
      const double edge = grid.box()[axis] / grid.cells(axis), low = edge * (cell % grid.cells(axis));
      ASSERT_GE(point[axis], low - 1e-14);
      ASSERT_LE(point[axis], low + edge + 1e-14);
    }
  }
}

TEST(Grid, CellHoldsThePoint) {
  expect_point_in_its_cell<2>();
  expect_point_in_its_cell<3>();
}

TEST(Grid, NumbersRunFastestAlongTheFirstAxis) {
  const Grid<3> grid(Vector<3>(2, 3, 4), {2, 3, 4});
  EXPECT_EQ(grid.size(), 24u);
  EXPECT_DOUBLE_EQ(grid.cell_volume(), 1);
  EXPECT_EQ(grid.cell_of({1.5, 0.5, 0.5}), 1u);
  EXPECT_EQ(grid.cell_of({0.5, 1.5, 0.5}), 2u);
  EXPECT_EQ(grid.cell_of({0.5, 0.5, 1.5}), 6u);
  EXPECT_EQ(grid.cell_of({2, 3, 4}), 23u);
}

TEST(Lanes, StoreWritesNoMoreThanTheVector) {
  double memory[] = {1, 2, 3, 4, 5};
  Lanes<3>::store(memory + 1, Lanes<3>::load(memory));
  EXPECT_EQ(memory[0], 1);
  EXPECT_EQ(memory[1], 1);
  EXPECT_EQ(memory[2], 2);
  EXPECT_EQ(memory[3], 3);
  EXPECT_EQ(memory[4], 5);
}

/// Every coordinate by itself is taken to the nearest edge.
TEST(Grid, TakesWhatIsOutsideToTheCellAtTheEdge) {
  const Grid<3> grid = odd_grid<3>();
  const Vector<3> inside = 0.4 * grid.box();
  for (int axis = 0; axis < 3; ++axis)
    for (const double beyond : {1e-300, 0.1, 1e30}) {
      Vector<3> edge = inside, point = inside;
      edge[axis] = 0, point[axis] = -beyond;
      EXPECT_EQ(grid.cell_of(point), grid.cell_of(edge));
      edge[axis] = grid.box()[axis], point[axis] = edge[axis] + beyond;
      EXPECT_EQ(grid.cell_of(point), grid.cell_of(edge));
    }
}

/// Whatever the digits of the edges, the cell of the new position is the wanted one; positions inside stay.
TEST(Grid, PutsAPositionIntoACell) {
  const Grid<3> grid(Vector<3>(1.7, 0.3, 12.1), {7, 3, 11});
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell)
    for (int trial = 0; trial < 20; ++trial) {
      Vector<3> position;
      for (int axis = 0; axis < 3; ++axis) position[axis] = grid.box()[axis] * (1.4 * random.uniform() - 0.2);
      const Vector<3> before = position;
      grid.put_into(cell, position);
      ASSERT_EQ(grid.cell_of(position), cell);
      ASSERT_TRUE((position.array() >= 0).all() && (position.array() <= grid.box().array()).all());
      const bool inside = (before.array() >= 0).all() && (before.array() < grid.box().array()).all();
      if (inside && grid.cell_of(before) == cell) {
        ASSERT_EQ(position, before);
      }
    }
}

}  // namespace
}  // namespace sandglass::grid_test
