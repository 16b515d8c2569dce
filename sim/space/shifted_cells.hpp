#pragma once

#include "sim/space/grid.hpp"

namespace sandglass {

/// The cells of a grid, all displaced by the same part of a cell. Their number stays: across a periodic edge they go
/// around, and at a wall the first is wider by as much as the last is narrower. A single cell between walls stays.
template <int D>
class ShiftedCells {
 public:
  ShiftedCells(const Grid<D>& grid, const std::array<bool, D>& periodic)
      : grid_(grid), periodic_(periodic), part_(Vector<D>::Zero()) {}

  /// Displacement in cell edges, from -1/2 to 1/2 along each axis.
  void shift(const Vector<D>& part);
  const Vector<D>& part() const { return part_; }

  bool periodic(int axis) const { return periodic_[static_cast<std::size_t>(axis)]; }

  /// As Grid::cell_of.
  std::uint32_t cell_of(const Vector<D>& position) const {
    std::uint32_t cell = 0;
    for (int axis = D - 1; axis >= 0; --axis)
      cell = cell * grid_.cells(axis) + coordinate(position[axis], axis);
    return cell;
  }
  /// As Grid::put_into.
  void put_into(std::uint32_t cell, Vector<D>& position) const;
  /// Of a cell, relative to one of the grid.
  double volume(std::uint32_t cell) const;

 private:
  std::uint32_t coordinate(double x, int axis) const {
    const double cells = grid_.cells(axis);
    const double along = std::floor(std::clamp(x * grid_.cells_per_length(axis) - part_[axis], -1.0, cells));
    if (along < 0) return periodic(axis) ? grid_.cells(axis) - 1 : 0;
    if (along < cells) return static_cast<std::uint32_t>(along);
    return periodic(axis) ? 0 : grid_.cells(axis) - 1;
  }
  double put_along(int axis, std::uint32_t place, double x) const;

  Grid<D> grid_;
  std::array<bool, D> periodic_;
  Vector<D> part_;
};

extern template class ShiftedCells<2>;
extern template class ShiftedCells<3>;

}  // namespace sandglass
