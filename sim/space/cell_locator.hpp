#pragma once

#include "sim/space/lanes.hpp"
#include "sim/space/lattice_of_cells.hpp"

namespace sandglass {

/// Grid::cell_of for the inner loop, all axes at once, where the cells are those of a grid. The slow twin is Grid::cell_of.
template <int D>
class CellLocator {
 public:
  using Real = typename Lanes<D>::Real;
  using Whole = typename Lanes<D>::Whole;

  explicit CellLocator(const LatticeOfCells<D>& cells) : per_length_{}, last_{}, stride_{} {
    const Grid<D>& grid = cells.grid();
    int stride = 1;
    for (int axis = 0; axis < D; ++axis) {
      per_length_[axis] = grid.cells_per_length(axis);
      last_[axis] = static_cast<int>(grid.cells(axis)) - 1;
      stride_[axis] = stride;
      stride *= static_cast<int>(grid.cells(axis));
    }
  }

  std::uint32_t cell_of(const Real& position) const {
    const Whole coordinate = __builtin_convertvector(position * per_length_, Whole);
    const Whole inside = coordinate < last_ ? coordinate : last_;
    const Whole part = inside * stride_;
    if constexpr (D == 2)
      return static_cast<std::uint32_t>(part[0] + part[1]);
    else
      return static_cast<std::uint32_t>(part[0] + part[1] + part[2]);
  }

 private:
  Real per_length_;
  Whole last_, stride_;
};

/// The same for the cells of any lattice.
template <int D>
class LatticeLocator {
 public:
  explicit LatticeLocator(const LatticeOfCells<D>& cells) : cells_(cells) {}

  std::uint32_t cell_of(const typename Lanes<D>::Real& position) const {
    Vector<D> point;
    for (int axis = 0; axis < D; ++axis) point[axis] = position[axis];
    return cells_.cell_of(point);
  }

 private:
  const LatticeOfCells<D>& cells_;
};

}  // namespace sandglass
