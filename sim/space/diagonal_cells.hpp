#pragma once

#include "sim/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace sandglass {

/// Squares that stand on a corner, in 2D; rhombi where the box asks for it. Their middles are the points of a lattice of
/// half diagonals h whose coordinates i and j are both even or both odd, so that walls halve the cells whose middles stand
/// on them, and quarter those in a corner of the box. Cell numbers run fastest along axis 0, row by row.
class DiagonalCells {
 public:
  /// `cells` from corner to corner along each axis.
  DiagonalCells(const Vector<2>& box, const std::array<std::uint32_t, 2>& cells,
                const std::array<bool, 2>& periodic);

  std::uint32_t size() const;

  /// As Grid::cell_of.
  std::uint32_t cell_of(const Vector<2>& position) const {
    const double x = std::clamp(position[0] * per_half_[0], 0.0, static_cast<double>(last_[0]));
    const double y = std::clamp(position[1] * per_half_[1], 0.0, static_cast<double>(last_[1]));
    const auto up = static_cast<std::int64_t>(std::floor(0.5 * (y + x + 1)));
    const auto down = static_cast<std::int64_t>(std::floor(0.5 * (y - x + 1)));
    return number(around(up - down, 0), around(up + down, 1));
  }
  /// A near position of this cell, in the box, for which cell_of() gives the cell; itself where it is there.
  void put_into(std::uint32_t cell, Vector<2>& position) const;
  /// Of a cell, relative to one without a wall.
  double volume(std::uint32_t cell) const;
  /// Distance of opposite sides.
  double width() const;

  /// The cell behind a side: up axis 0 to the right and up, up axis 1 to the left and up. None behind a wall.
  std::optional<std::uint32_t> neighbour(std::uint32_t cell, int axis, bool up) const;
  /// Unit vector from the middle of a cell to that of its neighbour up the axis.
  Vector<2> direction(int axis) const;
  /// Colour on a checkerboard: 0 or 1, another than that of every neighbour.
  std::uint32_t parity(std::uint32_t cell) const { return static_cast<std::uint32_t>(middle(cell).row % 2); }

  /// All points of the lattice, of which every second is the middle of a cell: their numbers along each axis, and the
  /// point of a cell, counted along axis 0.
  std::array<std::uint32_t, 2> points() const {
    return {static_cast<std::uint32_t>(last_[0] + !periodic_[0]),
            static_cast<std::uint32_t>(last_[1] + !periodic_[1])};
  }
  std::uint32_t point(std::uint32_t cell) const {
    const Middle at = middle(cell);
    return static_cast<std::uint32_t>(at.row) * points()[0] + static_cast<std::uint32_t>(at.column);
  }

 private:
  /// In half diagonals.
  struct Middle {
    std::int64_t column, row;
  };

  Middle middle(std::uint32_t cell) const;
  std::uint32_t number(std::int64_t column, std::int64_t row) const {
    return static_cast<std::uint32_t>(row / 2) * (in_even_ + in_odd_) +
           static_cast<std::uint32_t>(row % 2) * in_even_ + static_cast<std::uint32_t>(column / 2);
  }
  /// Across a periodic edge. Where four cells meet at an edge rounding may give one outside: its mirror image then.
  std::int64_t around(std::int64_t place, std::size_t axis) const {
    if (periodic_[axis])
      return place < 0 ? place + last_[axis] : place < last_[axis] ? place : place - last_[axis];
    return place < 0 ? -place : place <= last_[axis] ? place : 2 * last_[axis] - place;
  }
  bool behind_wall(std::int64_t place, std::size_t axis) const {
    return !periodic_[axis] && (place < 0 || place > last_[axis]);
  }

  Vector<2> box_, per_half_;
  std::array<bool, 2> periodic_;
  std::array<std::int64_t, 2> last_;  ///< lattice point on the far edge
  std::uint32_t in_even_, in_odd_;    ///< cells of a row
};

}  // namespace sandglass
