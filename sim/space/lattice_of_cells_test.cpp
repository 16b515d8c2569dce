#include "sim/space/lattice_of_cells.hpp"

#include "sim/space/neighbours.hpp"
#include "sim/space/test_lattice.hpp"

#include <set>

#include <gtest/gtest.h>

namespace sandglass::lattice_of_cells_test {
namespace {

/// Every position belongs to one cell, and to each as many as its volume says. Chi-square of as many as there are cells,
/// less one: 5 standard deviations.
template <int D>
void expect_volumes(const LatticeOfCells<D>& lattice) {
  constexpr int kPoints = 50'000;
  std::vector<double> count(lattice.size());
  Random random = stream(1);
  for (int i = 0; i < kPoints; ++i) {
    const std::uint32_t cell = lattice.cell_of(inside(lattice.grid().box(), random));
    ASSERT_LT(cell, lattice.size());
    ++count[cell];
  }
  double chi = 0, whole = 0;
  for (std::uint32_t cell = 0; cell < lattice.size(); ++cell) {
    const double volume = lattice.volumes().empty() ? 1 : lattice.volumes()[cell];
    const double expected = kPoints * volume / lattice.grid().size();
    chi += (count[cell] - expected) * (count[cell] - expected) / expected;
    whole += volume;
  }
  EXPECT_NEAR(whole, lattice.grid().size(), 1e-9);
  EXPECT_LT(chi, lattice.size() + 5 * std::sqrt(2.0 * lattice.size()));
}

TEST(LatticeOfCells, CoversTheBoxByTheVolumesOfItsCells) {
  for_each_diagonal([](const LatticeOfCells<2>& lattice) { expect_volumes(lattice); });
  for_each_shifted<2>([](const LatticeOfCells<2>& lattice) { expect_volumes(lattice); });
  for_each_shifted<3>([](const LatticeOfCells<3>& lattice) { expect_volumes(lattice); });
}

/// The slow twin of diagonal cells: the nearest middle, in half diagonals along both axes together.
TEST(LatticeOfCells, DiagonalCellIsTheOneWithTheNearestMiddle) {
  for_each_diagonal([](const LatticeOfCells<2>& lattice) {
    const std::vector<Vector<2>> middles = middles_of_diagonal(lattice);
    ASSERT_EQ(middles.size(), lattice.size());
    Random random = stream(2);
    for (int i = 0; i < 2000; ++i) {
      const Vector<2> position = inside(lattice.grid().box(), random);
      std::uint32_t nearest = 0;
      const auto distance = [&](std::uint32_t cell) {
        return half_diagonals(lattice, position - middles[cell]).cwiseAbs().sum();
      };
      for (std::uint32_t cell = 0; cell < middles.size(); ++cell)
        if (distance(cell) < distance(nearest)) nearest = cell;
      ASSERT_EQ(lattice.cell_of(position), nearest) << position.transpose();
    }
  });
}

/// The slow twin of shifted cells: a look at the edges of all cells along each axis.
template <int D>
void expect_shifted_edges(const LatticeOfCells<D>& lattice) {
  const Grid<D>& grid = lattice.grid();
  const Vector<D> part = lattice.shifted_cells()->part();
  Random random = stream(3);
  for (int i = 0; i < 2000; ++i) {
    const Vector<D> position = inside(grid.box(), random);
    std::uint32_t expected = 0, stride = 1;
    for (int axis = 0; axis < D; ++axis) {
      const std::uint32_t cells = grid.cells(axis);
      const double along = position[axis] / grid.box()[axis] * cells;
      std::uint32_t place = 0;
      while (place + 1 < cells && along >= place + 1 + part[axis]) ++place;
      const bool around = is_periodic(lattice, axis);
      if (around && along < part[axis]) place = cells - 1;
      if (around && along >= cells + part[axis]) place = 0;
      expected += stride * place;
      stride *= cells;
    }
    ASSERT_EQ(lattice.cell_of(position), expected) << position.transpose();
  }
}

TEST(LatticeOfCells, ShiftedCellIsTheOneBetweenItsEdges) {
  for_each_shifted<2>(expect_shifted_edges<2>);
  for_each_shifted<3>(expect_shifted_edges<3>);
}

/// From anywhere near the box, walls and corners included; who is there stays.
template <int D>
void expect_to_put_into(const LatticeOfCells<D>& lattice) {
  Random random = stream(4);
  for (int i = 0; i < 3000; ++i) {
    Vector<D> position = inside(lattice.grid().box(), random);
    const Vector<D> before = position;
    lattice.put_into(lattice.cell_of(position), position);
    ASSERT_EQ(position, before);
    for (int axis = 0; axis < D; ++axis) position[axis] += lattice.width() * (2 * random.uniform() - 1);
    const auto cell = static_cast<std::uint32_t>(lattice.size() * random.uniform());
    lattice.put_into(cell, position);
    ASSERT_EQ(lattice.cell_of(position), cell) << position.transpose();
    ASSERT_GE(position.minCoeff(), 0);
    ASSERT_LE((position - lattice.grid().box()).maxCoeff(), 0);
  }
}

TEST(LatticeOfCells, PutsPositionsIntoCells) {
  for_each_diagonal(expect_to_put_into<2>);
  for_each_shifted<2>(expect_to_put_into<2>);
  for_each_shifted<3>(expect_to_put_into<3>);
}

/// A position beside a side comes to the side, across a seam too.
TEST(LatticeOfCells, PutsPositionsToTheNearerSide) {
  auto shifted = LatticeOfCells<2>::shifted(Grid<2>(Vector<2>(4, 4), {4, 4}), {true, true});
  shifted.shift({0.25, 0.25});
  Vector<2> position(3.9, 1);  // 0.35 before the first cell, which begins at 0.25
  shifted.put_into(0, position);
  EXPECT_NEAR(position[0], 0.25, 1e-14);
  EXPECT_EQ(position[1], 1);
  const auto diagonal = LatticeOfCells<2>::diagonal(Grid<2>(Vector<2>(4, 4), {2, 2}), {true, true});
  position = {3, 0.1};  // the cell of the corner ends where 4 - x + y is one
  diagonal.put_into(diagonal.cell_of({0, 0}), position);
  EXPECT_LT((position - Vector<2>(3.05, 0.05)).norm(), 1e-14);
}

TEST(LatticeOfCells, DiagonalNeighboursLieBehindTheSides) {
  for_each_diagonal([](const LatticeOfCells<2>& lattice) {
    const Neighbours<2> neighbours(lattice, periodic_axes(lattice));
    const std::vector<Vector<2>> middles = middles_of_diagonal(lattice);
    const Vector<2> half = half_diagonal(lattice);
    for (std::uint32_t cell = 0; cell < lattice.size(); ++cell) {
      std::multiset<std::uint32_t> expected, found;
      for (const double right : {-1.0, 1.0})
        for (const double up : {-1.0, 1.0})
          if (const auto there = wrapped(lattice, middles[cell] + Vector<2>(right * half[0], up * half[1])))
            expected.insert(lattice.cell_of(*there));
      neighbours.for_each_neighbour(cell, [&](std::uint32_t other, int axis, bool up) {
        found.insert(other);
        for (const std::uint64_t turn : {0, 1})
          EXPECT_NE(neighbours.colour(cell, turn), neighbours.colour(other, turn));
        const Vector<2> direction(neighbours.towards(Vector<2>::UnitX(), axis, up),
                                  neighbours.towards(Vector<2>::UnitY(), axis, up));
        const auto there = wrapped(lattice, middles[cell] + half.norm() * direction);
        ASSERT_TRUE(there.has_value());
        EXPECT_EQ(lattice.cell_of(*there), other);
      });
      EXPECT_EQ(found, expected);
    }
  });
}

TEST(LatticeOfCells, CheckerboardOfDiagonalCellsHasEveryPairOnce) {
  for_each_diagonal([](const LatticeOfCells<2>& lattice) {
    const Neighbours<2> neighbours(lattice, periodic_axes(lattice));
    for (const int axis : {0, 1}) {
      std::size_t pairs = 0, sides = 0;
      for (int colour = 0; colour < neighbours.colours(axis); ++colour) {
        std::set<std::uint32_t> taken;
        neighbours.for_each_pair(axis, colour, [&](std::uint32_t one, std::uint32_t two) {
          EXPECT_TRUE(taken.insert(one).second);
          EXPECT_TRUE(taken.insert(two).second);
          ++pairs;
        });
      }
      for (std::uint32_t cell = 0; cell < lattice.size(); ++cell)
        sides += neighbours.neighbour(cell, axis, true).has_value();
      EXPECT_EQ(pairs, sides);
    }
  });
}

TEST(LatticeOfCells, WidthIsTheDistanceOfOppositeSides) {
  const Grid<2> corners(Vector<2>(6, 8), {2, 2});  // half diagonals 1.5 and 2, sides 2.5
  EXPECT_NEAR((LatticeOfCells<2>::diagonal(corners, {true, false}).width()), 2 * 1.5 * 2 / 2.5, 1e-15);
  EXPECT_EQ(LatticeOfCells<2>(corners).width(), 3);
  EXPECT_EQ((LatticeOfCells<2>::shifted(corners, {true, false}).width()), 3);
}

}  // namespace
}  // namespace sandglass::lattice_of_cells_test
