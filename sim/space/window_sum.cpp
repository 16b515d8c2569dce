#include "sim/space/window_sum.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

template <int D, class Real>
WindowSum<D, Real>::WindowSum(const Grid<D>& grid, const std::array<bool, D>& periodic,
                              double particles_per_cell, double wanted)
    : grid_(grid), periodic_(periodic), sum_(grid.size()), scratch_(grid.size()) {
  std::uint32_t longest = 1;
  for (int axis = 0; axis < D; ++axis) longest = std::max(longest, grid.cells(axis));
  const auto held = [&](int half) {
    double cells = 1;
    for (int axis = 0; axis < D; ++axis) cells *= std::min<double>(2.0 * half + 1, grid.cells(axis));
    return cells * particles_per_cell;
  };
  while (held(half_width_) < wanted && static_cast<std::uint32_t>(2 * half_width_ + 1) < longest)
    ++half_width_;

  std::fill(sum_.begin(), sum_.end(), Real{1});
  for (int axis = 0; axis < D; ++axis) sum_along(axis);
  extent_ = sum_;
}

template <int D, class Real>
void WindowSum<D, Real>::update(std::span<const std::uint32_t> offsets) {
  for (std::size_t cell = 0; cell < sum_.size(); ++cell)
    sum_[cell] = static_cast<Real>(offsets[cell + 1] - offsets[cell]);
  sum();
}

template <int D, class Real>
void WindowSum<D, Real>::sum() {
  if (half_width_ == 0) return;
  for (int axis = 0; axis < D; ++axis) sum_along(axis);
}

template <int D, class Real>
void WindowSum<D, Real>::sum_along(int axis) {
  std::size_t stride = 1;
  for (int lower = 0; lower < axis; ++lower) stride *= grid_.cells(lower);
  const std::size_t count = grid_.cells(axis), slab = stride * count;
  for (std::size_t base = 0; base < sum_.size(); base += slab)
    for (std::size_t lane = 0; lane < stride; ++lane)
      sum_line(&sum_[base + lane], &scratch_[base + lane], count, stride,
               periodic_[static_cast<std::size_t>(axis)]);
  sum_.swap(scratch_);
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
