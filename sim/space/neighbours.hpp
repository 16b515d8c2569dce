#pragma once

#include "sim/space/lattice_of_cells.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace sandglass {

/// Which cells share a side, across periodic edges too, and these pairs on a checkerboard: within one colour of an axis no
/// cell has two partners, so that its pairs may be worked on in any order. The axes of diagonal cells are their own.
template <int D>
class Neighbours {
 public:
  Neighbours(const LatticeOfCells<D>& cells, const std::array<bool, D>& periodic)
      : diagonal_(cells.diagonal_cells()), periodic_(periodic), size_(cells.size()) {
    std::uint32_t stride = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      cells_[axis] = cells.grid().cells(static_cast<int>(axis));
      stride_[axis] = stride;
      stride *= cells_[axis];
      alternate_ = alternate_ && (diagonal_ || !periodic[axis] || cells_[axis] == 1 || cells_[axis] % 2 == 0);
    }
  }

  /// The next cell along an axis; none behind a wall. A periodic axis of one cell is its own neighbour.
  std::optional<std::uint32_t> neighbour(std::uint32_t cell, int axis, bool up) const {
    if (diagonal_) return diagonal_->neighbour(cell, axis, up);
    const auto a = static_cast<std::size_t>(axis);
    const std::uint32_t place = coordinate(cell, a);
    if (!periodic_[a] && place == (up ? cells_[a] - 1 : 0)) return std::nullopt;
    return beside(cell, axis, place)[up];
  }

  /// Calls visit(neighbour, axis, up) for every cell that shares a side with this one; a cell that is its own neighbour is
  /// none.
  template <class Visit>
  void for_each_neighbour(std::uint32_t cell, Visit visit) const {
    std::uint32_t rest = cell;
    const auto visit_along = [&](int axis) {
      const std::uint32_t cells = cells_[static_cast<std::size_t>(axis)];
      const auto [down, up] = beside(cell, axis, rest % cells);
      rest /= cells;
      if (down != cell) visit(down, axis, false);
      if (up != cell) visit(up, axis, true);
    };
    visit_along(0);
    visit_along(1);
    if constexpr (D == 3) visit_along(2);
  }
  /// Component of a vector in the direction from a cell to its neighbour.
  double towards(const Vector<D>& vector, int axis, bool up) const {
    double component = vector[axis];
    if constexpr (D == 2)
      if (diagonal_) component = vector.dot(diagonal_->direction(axis));
    return up ? component : -component;
  }

  /// Calls visit(other) for this cell and every one that shares a side, an edge or a corner with it; more than once for the
  /// same where a periodic axis has one or two cells.
  template <class Visit>
  void for_each_around(std::uint32_t cell, Visit visit) const {
    visit_around(cell, 0, visit);
  }

  /// Colour on a checkerboard over all axes, 0 or 1, that swaps with every turn. A periodic axis with an odd number of cells
  /// has one pair of neighbouring layers alike, which moves on by a layer every other turn.
  std::uint32_t colour(std::uint32_t cell, std::uint64_t turn) const {
    if (diagonal_) return static_cast<std::uint32_t>((diagonal_->parity(cell) + turn) % 2);
    std::uint64_t sum = turn;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::uint64_t place = cell % cells_[axis];
      cell /= cells_[axis];
      sum += periodic_[axis] && cells_[axis] % 2 == 1 ? (place + turn / 2) % cells_[axis] : place;
    }
    return static_cast<std::uint32_t>(sum % 2);
  }

  /// Calls visit(cell) for every cell that has this colour at this turn, in their order.
  template <class Visit>
  void for_each_of_colour(std::uint32_t wanted, std::uint64_t turn, Visit visit) const {
    if (diagonal_) {
      for (std::uint32_t cell = 0; cell < size_; ++cell)
        if (colour(cell, turn) == wanted) visit(cell);
      return;
    }
    // Along a row colours alternate, but for the seam of an odd number of cells.
    const std::uint32_t row = cells_[0], seam = row - static_cast<std::uint32_t>(turn / 2 % row);
    const auto visit_part = [&](std::uint32_t first, std::uint32_t last) {
      if (first == last) return;
      for (std::uint32_t cell = first + (colour(first, turn) != wanted); cell < last; cell += 2) visit(cell);
    };
    for (std::uint32_t first = 0; first < size_; first += row) {
      const std::uint32_t middle = first + (periodic_[0] && row % 2 == 1 ? seam : row);
      visit_part(first, middle);
      visit_part(middle, first + row);
    }
  }

  /// Whether all neighbours differ in colour, at every turn.
  bool alternate() const { return alternate_; }

  /// Three where a periodic axis has an odd number of cells, else two.
  int colours(int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return !diagonal_ && periodic_[a] && cells_[a] % 2 == 1 ? 3 : 2;
  }
  /// Calls visit(cell, next cell up the axis) for every pair of one colour. All colours together give every pair of
  /// different cells once; two cells on a periodic axis have two sides in common and come twice.
  template <class Visit>
  void for_each_pair(int axis, int colour, Visit visit) const {
    for (std::uint32_t cell = 0; cell < size_; ++cell) {
      const auto next = neighbour(cell, axis, true);
      if (next && *next != cell && colour_of(cell, axis) == colour) visit(cell, *next);
    }
  }

 private:
  template <class Visit>
  void visit_around(std::uint32_t cell, int axis, Visit& visit) const {
    if (axis == D) return visit(cell);
    visit_around(cell, axis + 1, visit);
    for (const bool up : {false, true})
      if (const auto next = neighbour(cell, axis, up)) visit_around(*next, axis + 1, visit);
  }

  /// The next cells down and up an axis along which this one has `place`; itself where there is none.
  std::array<std::uint32_t, 2> beside(std::uint32_t cell, int axis, std::uint32_t place) const {
    if (diagonal_)
      return {diagonal_->neighbour(cell, axis, false).value_or(cell),
              diagonal_->neighbour(cell, axis, true).value_or(cell)};
    const auto a = static_cast<std::size_t>(axis);
    const std::uint32_t last = cells_[a] - 1, across = periodic_[a] ? last * stride_[a] : 0;
    return {place > 0 ? cell - stride_[a] : cell + across, place < last ? cell + stride_[a] : cell - across};
  }

  std::uint32_t coordinate(std::uint32_t cell, std::size_t axis) const {
    return cell / stride_[axis] % cells_[axis];
  }
  /// The pair across the edge of an odd periodic axis has a colour of its own.
  int colour_of(std::uint32_t cell, int axis) const {
    if (diagonal_) return static_cast<int>(diagonal_->parity(cell));
    const auto a = static_cast<std::size_t>(axis);
    const std::uint32_t place = coordinate(cell, a);
    return colours(axis) == 3 && place + 1 == cells_[a] ? 2 : static_cast<int>(place % 2);
  }
  std::optional<DiagonalCells> diagonal_;
  std::array<bool, D> periodic_;
  std::array<std::uint32_t, D> cells_, stride_;
  std::uint32_t size_;
  bool alternate_ = true;
};

}  // namespace sandglass
