#pragma once

#include "sim/space/lattice_of_cells.hpp"
#include "sim/space/shared_cells.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sandglass {

/// Sums of a number per cell over a window of cells around each cell: 2 h + 1 cells per axis, wrapped on periodic axes
/// and cut off at walls; of diagonal cells, those with their middles in 2 h + 1 half diagonals per axis. Whole axes shorter than the window are summed once. Sums run along a line and are exact for
/// whole numbers: below 2^24 in float, which suits counts of particles, below 2^53 in double.
template <int D, class Real = float>
class WindowSum {
 public:
  WindowSum(const LatticeOfCells<D>& cells, const std::array<bool, D>& periodic, int half_width);
  /// The smallest window that holds at least `wanted` particles on average, or the whole box.
  WindowSum(const LatticeOfCells<D>& cells, const std::array<bool, D>& periodic, double particles_per_cell,
            double wanted)
      : WindowSum(cells, periodic, half_width_for(cells, particles_per_cell, wanted)) {}
  static int half_width_for(const LatticeOfCells<D>& cells, double particles_per_cell, double wanted);

  /// Number of each cell, to be written; after sum() the sum over the window of each cell.
  std::span<Real> values() { return sum_; }
  void sum();
  /// The same for the particles of each cell, `offsets` as of ParticleStore.
  void update(std::span<const std::uint32_t> offsets, const SharedCells& work);
  void update(std::span<const std::uint32_t> offsets) { update(offsets, all_cells(offsets)); }

  double sum(std::uint32_t cell) const { return static_cast<double>(sum_[cell]); }
  /// Relative volumes of the cells, where they differ or have changed: cells() counts them.
  void set_volumes(std::span<const double> volumes);
  /// Cells in the window of a cell.
  double cells(std::uint32_t cell) const { return static_cast<double>(extent_[cell]); }
  int half_width() const { return half_width_; }
  std::size_t bytes() const {
    return (sum_.capacity() + scratch_.capacity() + extent_.capacity() + spread_.capacity()) * sizeof(Real) +
           point_.capacity() * sizeof(std::uint32_t);
  }

 private:
  void sum_box(std::vector<Real>& numbers);
  void sum_along(int axis, std::vector<Real>& numbers);
  void sum_line(const Real* line, Real* out, std::size_t count, std::size_t stride, bool periodic) const;

  Grid<D> grid_;  ///< cells; of diagonal ones the points among which their middles are
  std::array<bool, D> periodic_;
  int half_width_ = 0;
  std::vector<Real> sum_, scratch_, extent_;
  std::vector<std::uint32_t> point_;  ///< of each diagonal cell
  std::vector<Real> spread_;          ///< by point
};

extern template class WindowSum<2>;
extern template class WindowSum<3>;
extern template class WindowSum<2, double>;
extern template class WindowSum<3, double>;

}  // namespace sandglass
