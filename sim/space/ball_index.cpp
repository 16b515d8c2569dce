#include "sim/space/ball_index.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <numeric>

namespace sandglass {

namespace {
/// Cells, and entries of their lists, per ball: a few of each while balls are spread out; large ones among small ones and
/// balls that overlap many others make cells coarser.
constexpr double kCellsPerBall = 4, kEntriesPerBall = 64;
}  // namespace

template <int D>
BallIndex<D>::BallIndex(std::vector<Ball<D>> balls) : balls_(std::move(balls)) {
  if (empty()) return;
  Vector<D> low = Vector<D>::Constant(HUGE_VAL), high = -low;
  for (const Ball<D>& ball : balls_) {
    SANDGLASS_EXPECT(ball.centre.allFinite() && ball.radius > 0);
    low = low.cwiseMin(Vector<D>(ball.centre - Vector<D>::Constant(ball.radius)));
    high = high.cwiseMax(Vector<D>(ball.centre + Vector<D>::Constant(ball.radius)));
  }
  origin_ = low;
  extent_ = high - low;
  const auto count = static_cast<double>(balls_.size());
  double edge = std::pow(extent_.prod() / (kCellsPerBall * count), 1.0 / D);
  for (choose_cells(edge); entries_wanted() > kEntriesPerBall * count; choose_cells(edge)) edge *= 1.5;
  fill();
}

/// Long and thin: an axis shorter than the edge has one cell, and the others have fewer than asked for.
template <int D>
void BallIndex<D>::choose_cells(double edge) {
  for (int axis = 0; axis < D; ++axis) {
    const double cells = std::max(1.0, std::floor(extent_[axis] / edge));
    cells_[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(cells);
    per_length_[axis] = cells / extent_[axis];
  }
}

template <int D>
double BallIndex<D>::entries_wanted() const {
  double entries = 0;
  for (const Ball<D>& ball : balls_) {
    const Cell from = cell_of(ball.centre - Vector<D>::Constant(ball.radius));
    const Cell to = cell_of(ball.centre + Vector<D>::Constant(ball.radius));
    double cells = 1;
    for (std::size_t axis = 0; axis < D; ++axis) cells *= to[axis] - from[axis] + 1;
    entries += cells;
  }
  return entries;
}

/// A counting sort: how many in each cell, then where each cell begins, then the balls in ascending order.
template <int D>
void BallIndex<D>::fill() {
  const auto for_each_entry = [this](auto function) {
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
      const Vector<D> reach = Vector<D>::Constant(balls_[i].radius);
      const Cell from = cell_of(balls_[i].centre - reach), to = cell_of(balls_[i].centre + reach);
      Cell cell = from;
      do function(number_of(cell), i);
      while (advance(cell, from, to));
    }
  };
  const std::size_t cells = std::accumulate(cells_.begin(), cells_.end(), std::size_t{1}, std::multiplies{});
  offset_.assign(cells + 1, 0);
  for_each_entry([this](std::size_t cell, std::uint32_t) { ++offset_[cell + 1]; });
  std::inclusive_scan(offset_.begin(), offset_.end(), offset_.begin());
  entries_.resize(offset_.back());
  std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
  for_each_entry([&](std::size_t cell, std::uint32_t i) { entries_[next[cell]++] = i; });
}

template <int D>
std::size_t BallIndex<D>::bytes() const {
  return balls_.capacity() * sizeof(Ball<D>) +
         (offset_.capacity() + entries_.capacity()) * sizeof(std::uint32_t);
}

template class BallIndex<2>;
template class BallIndex<3>;

}  // namespace sandglass
