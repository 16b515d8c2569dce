#pragma once

#include "sim/space/grid.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sandglass {

/// Sums of cell counts over a window of cells around each cell: 2 h + 1 cells per axis, wrapped on periodic axes and cut
/// off at walls. Whole axes shorter than the window are summed once.
template <int D>
class WindowSum {
 public:
  /// The smallest window that holds at least `wanted` particles on average, or the whole box.
  WindowSum(const Grid<D>& grid, const std::array<bool, D>& periodic, double particles_per_cell,
            double wanted);

  /// `offsets` as of ParticleStore. Afterwards sum(c) and cells(c) describe the window of cell c.
  void update(std::span<const std::uint32_t> offsets);

  double sum(std::uint32_t cell) const { return sum_[cell]; }
  /// Cells in the window of a cell.
  double cells(std::uint32_t cell) const { return extent_[cell]; }
  int half_width() const { return half_width_; }
  std::size_t bytes() const {
    return (sum_.capacity() + scratch_.capacity() + extent_.capacity()) * sizeof(float);
  }

 private:
  void sum_along(int axis);
  void sum_line(const float* line, float* out, std::size_t count, std::size_t stride, bool periodic) const;

  Grid<D> grid_;
  std::array<bool, D> periodic_;
  int half_width_ = 0;
  std::vector<float> sum_, scratch_, extent_;  ///< counts below 2^24 are exact
};

extern template class WindowSum<2>;
extern template class WindowSum<3>;

}  // namespace sandglass
