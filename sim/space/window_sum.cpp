#include "sim/space/window_sum.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

template <int D, class Real>
int WindowSum<D, Real>::half_width_for(const LatticeOfCells<D>& cells, double particles_per_cell,
                                       double wanted) {
  const Grid<D> points = cells.points();
  if (cells.diagonal_cells()) particles_per_cell *= static_cast<double>(cells.size()) / points.size();
  std::uint32_t longest = 1;
  for (int axis = 0; axis < D; ++axis) longest = std::max(longest, points.cells(axis));
  const auto held = [&](int half) {
    double held_cells = 1;
    for (int axis = 0; axis < D; ++axis) held_cells *= std::min<double>(2.0 * half + 1, points.cells(axis));
    return held_cells * particles_per_cell;
  };
  int half = 0;
  while (held(half) < wanted && static_cast<std::uint32_t>(2 * half + 1) < longest) ++half;
  return half;
}

template <int D, class Real>
WindowSum<D, Real>::WindowSum(const LatticeOfCells<D>& cells, const std::array<bool, D>& periodic,
                              int half_width)
    : grid_(cells.points()),
      periodic_(periodic),
      half_width_(half_width),
      sum_(cells.size()),
      scratch_(grid_.size()) {
  if (cells.diagonal_cells()) {
    spread_.resize(grid_.size());
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
      point_.push_back(cells.diagonal_cells()->point(cell));
  }
  std::fill(sum_.begin(), sum_.end(), Real{1});
  sum();
  extent_ = sum_;
  set_volumes(cells.volumes());
}

template <int D, class Real>
void WindowSum<D, Real>::set_volumes(std::span<const double> volumes) {
  if (volumes.empty()) return;
  for (std::size_t cell = 0; cell < sum_.size(); ++cell) sum_[cell] = static_cast<Real>(volumes[cell]);
  sum();
  extent_ = sum_;
}

template <int D, class Real>
void WindowSum<D, Real>::update(std::span<const std::uint32_t> offsets, const SharedCells& work) {
  for (std::size_t cell = 0; cell < sum_.size(); ++cell)
    sum_[cell] = static_cast<Real>(offsets[cell + 1] - offsets[cell]);
  work.complete<Real>(sum_);
  sum();
}

template <int D, class Real>
void WindowSum<D, Real>::sum() {
  if (half_width_ == 0) return;
  if (point_.empty()) return sum_box(sum_);
  std::fill(spread_.begin(), spread_.end(), Real{0});
  for (std::size_t cell = 0; cell < point_.size(); ++cell) spread_[point_[cell]] = sum_[cell];
  sum_box(spread_);
  for (std::size_t cell = 0; cell < point_.size(); ++cell) sum_[cell] = spread_[point_[cell]];
}

template <int D, class Real>
void WindowSum<D, Real>::sum_box(std::vector<Real>& numbers) {
  for (int axis = 0; axis < D; ++axis) sum_along(axis, numbers);
}

template <int D, class Real>
void WindowSum<D, Real>::sum_along(int axis, std::vector<Real>& numbers) {
  std::size_t stride = 1;
  for (int lower = 0; lower < axis; ++lower) stride *= grid_.cells(lower);
  const std::size_t count = grid_.cells(axis), slab = stride * count;
  for (std::size_t base = 0; base < numbers.size(); base += slab)
    for (std::size_t lane = 0; lane < stride; ++lane)
      sum_line(&numbers[base + lane], &scratch_[base + lane], count, stride,
               periodic_[static_cast<std::size_t>(axis)]);
  numbers.swap(scratch_);
}

template <int D, class Real>
void WindowSum<D, Real>::sum_line(const Real* line, Real* out, std::size_t count, std::size_t stride,
                                  bool periodic) const {
  const auto half = static_cast<std::size_t>(half_width_);
  const bool whole = 2 * half + 1 >= count;
  Real running = 0;
  if (whole && periodic) {
    for (std::size_t i = 0; i < count; ++i) running += line[i * stride];
    for (std::size_t i = 0; i < count; ++i) out[i * stride] = running;
    return;
  }
  for (std::size_t i = 0; i < std::min(half, count); ++i) running += line[i * stride];
  if (periodic)
    for (std::size_t i = count - half; i < count; ++i) running += line[i * stride];
  for (std::size_t i = 0; i < count; ++i) {
    if (i + half < count)
      running += line[(i + half) * stride];
    else if (periodic)
      running += line[(i + half - count) * stride];
    out[i * stride] = running;
    if (i >= half)
      running -= line[(i - half) * stride];
    else if (periodic)
      running -= line[(i + count - half) * stride];
  }
}

template class WindowSum<2>;
template class WindowSum<3>;
template class WindowSum<2, double>;
template class WindowSum<3, double>;

}  // namespace sandglass
