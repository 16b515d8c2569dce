#include "sim/space/lattice_of_cells.hpp"

namespace sandglass {

template <int D>
LatticeOfCells<D> LatticeOfCells<D>::shifted(const Grid<D>& grid, const std::array<bool, D>& periodic) {
  LatticeOfCells lattice(grid);
  lattice.shifted_.emplace(grid, periodic);
  for (std::size_t axis = 0; axis < D; ++axis)
    if (!periodic[axis] && grid.cells(static_cast<int>(axis)) > 1) lattice.volumes_.resize(grid.size());
  lattice.shift(Vector<D>::Zero());
  return lattice;
}

template <int D>
LatticeOfCells<D> LatticeOfCells<D>::diagonal(const Grid<D>& corners,
                                              const std::array<bool, D>& periodic) requires(D == 2) {
  LatticeOfCells lattice(Grid<D>(corners.box(), {corners.cells(0), 2 * corners.cells(1)}));
  lattice.diagonal_.emplace(corners.box(), std::array{corners.cells(0), corners.cells(1)}, periodic);
  if (periodic[0] && periodic[1]) return lattice;
  for (std::uint32_t cell = 0; cell < lattice.size(); ++cell)
    lattice.volumes_.push_back(lattice.diagonal_->volume(cell));
  return lattice;
}

template <int D>
double LatticeOfCells<D>::width() const {
  if (diagonal_) return diagonal_->width();
  double width = HUGE_VAL;
  for (int axis = 0; axis < D; ++axis) width = std::min(width, 1 / grid_.cells_per_length(axis));
  return width;
}

template <int D>
Grid<D> LatticeOfCells<D>::points() const {
  if constexpr (D == 2)
    if (diagonal_) return {grid_.box(), diagonal_->points()};
  return grid_;
}

template <int D>
void LatticeOfCells<D>::shift(const Vector<D>& part) {
  shifted_->shift(part);
  for (std::uint32_t cell = 0; cell < volumes_.size(); ++cell) volumes_[cell] = shifted_->volume(cell);
}

template class LatticeOfCells<2>;
template class LatticeOfCells<3>;

}  // namespace sandglass
