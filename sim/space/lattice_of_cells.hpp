#pragma once

#include "sim/space/diagonal_cells.hpp"
#include "sim/space/shifted_cells.hpp"

#include <optional>
#include <span>
#include <vector>

namespace sandglass {

/// The cells that cover a box: those of a grid, a grid that is displaced from time to time, or squares on a corner. Every
/// position belongs to one of them.
template <int D>
class LatticeOfCells {
 public:
  LatticeOfCells(const Grid<D>& grid) : grid_(grid) {}
  static LatticeOfCells shifted(const Grid<D>& grid, const std::array<bool, D>& periodic);
  /// `corners`: cells from corner to corner along each axis.
  static LatticeOfCells diagonal(const Grid<D>& corners,
                                 const std::array<bool, D>& periodic) requires(D == 2);

  /// As many cells as fill the box: its volumes are those of whole cells.
  const Grid<D>& grid() const { return grid_; }
  bool is_grid() const { return !shifted_ && !diagonal_; }
  const std::optional<ShiftedCells<D>>& shifted_cells() const { return shifted_; }
  const std::optional<DiagonalCells>& diagonal_cells() const { return diagonal_; }
  std::uint32_t size() const { return diagonal_ ? diagonal_->size() : grid_.size(); }
  /// Along an axis; from corner to corner where they stand on one.
  std::uint32_t cells(int axis) const { return grid_.cells(axis) / (diagonal_ && axis == 1 ? 2 : 1); }
  /// Smallest distance of opposite sides of a whole cell.
  double width() const;
  /// Of each cell, relative to a whole one; empty where all are whole. The address stays when the cells are displaced.
  std::span<const double> volumes() const { return volumes_; }
  /// Grid of the cells; of diagonal ones that of the points among which their middles are.
  Grid<D> points() const;

  std::uint32_t cell_of(const Vector<D>& position) const {
    if (shifted_) return shifted_->cell_of(position);
    if constexpr (D == 2)
      if (diagonal_) return diagonal_->cell_of(position);
    return grid_.cell_of(position);
  }
  /// As Grid::put_into.
  void put_into(std::uint32_t cell, Vector<D>& position) const {
    if (shifted_) return shifted_->put_into(cell, position);
    if constexpr (D == 2)
      if (diagonal_) return diagonal_->put_into(cell, position);
    grid_.put_into(cell, position);
  }

  /// Only where the cells are those of shifted().
  void shift(const Vector<D>& part);
  std::size_t bytes() const { return volumes_.capacity() * sizeof(double); }

 private:
  Grid<D> grid_;
  std::optional<ShiftedCells<D>> shifted_;
  std::optional<DiagonalCells> diagonal_;
  std::vector<double> volumes_;
};

extern template class LatticeOfCells<2>;
extern template class LatticeOfCells<3>;

}  // namespace sandglass
