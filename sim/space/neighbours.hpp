#pragma once

#include "sim/space/grid.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace sandglass {

/// Which cells of a grid share a side, across periodic edges too, and these pairs on a checkerboard: within one colour of
/// an axis no cell has two partners, so that its pairs may be worked on in any order.
template <int D>
class Neighbours {
 public:
  Neighbours(const Grid<D>& grid, const std::array<bool, D>& periodic) : periodic_(periodic) {
    std::uint32_t stride = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      cells_[axis] = grid.cells(static_cast<int>(axis));
      stride_[axis] = stride;
      stride *= cells_[axis];
    }
    size_ = stride;
  }

  /// The next cell along an axis; none behind a wall. A periodic axis of one cell is its own neighbour.
  std::optional<std::uint32_t> neighbour(std::uint32_t cell, int axis, bool up) const {
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
          visit(*next, Vector<D>((up ? 1.0 : -1.0) * Vector<D>::Unit(axis)));
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
    std::uint64_t sum = turn;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const std::uint64_t place = coordinate(cell, axis);
      sum += periodic_[axis] && cells_[axis] % 2 == 1 ? (place + turn / 2) % cells_[axis] : place;
    }
    return static_cast<std::uint32_t>(sum % 2);
  }

  /// Three where a periodic axis has an odd number of cells, else two.
  int colours(int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return periodic_[a] && cells_[a] % 2 == 1 ? 3 : 2;
  }
  /// Calls visit(cell, next cell up the axis) for every pair of one colour. All colours together give every pair of
  /// different cells once; two cells on a periodic axis have two sides in common and come twice.
  template <class Visit>
  void for_each_pair(int axis, int colour, Visit visit) const {
    const auto a = static_cast<std::size_t>(axis);
    for (std::uint32_t cell = 0; cell < size_; ++cell) {
      const auto next = neighbour(cell, axis, true);
      if (next && *next != cell && colour_of(coordinate(cell, a), axis) == colour) visit(cell, *next);
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

  std::uint32_t coordinate(std::uint32_t cell, std::size_t axis) const {
    return cell / stride_[axis] % cells_[axis];
  }
  /// The pair across the edge of an odd periodic axis has a colour of its own.
  int colour_of(std::uint32_t place, int axis) const {
    if (colours(axis) == 3 && place + 1 == cells_[static_cast<std::size_t>(axis)]) return 2;
    return static_cast<int>(place % 2);
  }

  std::array<bool, D> periodic_;
  std::array<std::uint32_t, D> cells_, stride_;
  std::uint32_t size_;
};

}  // namespace sandglass
