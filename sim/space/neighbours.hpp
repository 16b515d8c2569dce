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
    }
  }

  /// The next cell along an axis; none behind a wall. A periodic axis of one cell is its own neighbour.
  std::optional<std::uint32_t> neighbour(std::uint32_t cell, int axis, bool up) const {
    if (diagonal_) return diagonal_->neighbour(cell, axis, up);
    const auto a = static_cast<std::size_t>(axis);
    const std::uint32_t place = coordinate(cell, a), last = cells_[a] - 1;
    if (place != (up ? last : 0)) return up ? cell + stride_[a] : cell - stride_[a];
    if (!periodic_[a]) return std::nullopt;
    return up ? cell - last * stride_[a] : cell + last * stride_[a];
  }

  /// Calls visit(neighbour, unit vector towards it) for every cell that shares a side with this one; a cell that is its
  /// own neighbour is none.
  template <class Visit>
  void for_each_neighbour(std::uint32_t cell, Visit visit) const {
    for (int axis = 0; axis < D; ++axis)
      for (const bool up : {false, true})
        if (const auto next = neighbour(cell, axis, up); next && *next != cell)
          visit(*next, Vector<D>((up ? 1.0 : -1.0) * direction(axis)));
  }

  /// Colour on a checkerboard over all axes: 0 or 1, another than that of every neighbour, save across the seam of a
  /// periodic axis with an odd number of cells.
  std::uint32_t parity(std::uint32_t cell) const {
    if (diagonal_) return diagonal_->parity(cell);
    std::uint32_t sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += coordinate(cell, axis);
    return sum % 2;
  }

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
  /// Unit vector up an axis.
  Vector<D> direction(int axis) const {
    if constexpr (D == 2)
      if (diagonal_) return diagonal_->direction(axis);
    return Vector<D>::Unit(axis);
  }

  std::optional<DiagonalCells> diagonal_;
  std::array<bool, D> periodic_;
  std::array<std::uint32_t, D> cells_, stride_;
  std::uint32_t size_;
};

}  // namespace sandglass
