#pragma once

#include "sim/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sandglass {

/// A disk or a sphere.
template <int D>
struct Ball {
  Vector<D> centre;
  double radius;
};

/// Finds the balls that a box touches, at a cost that depends on those nearby only. Regular cells cover the balls; each
/// lists those whose bounding box overlaps it. Memory grows in proportion to the number of balls.
template <int D>
class BallIndex {
 public:
  BallIndex() = default;
  explicit BallIndex(std::vector<Ball<D>> balls);

  bool empty() const { return balls_.empty(); }
  std::span<const Ball<D>> balls() const { return balls_; }
  /// Shortest edge of a cell: a query over a box of few such edges is cheap.
  double cell_edge() const { return 1 / per_length_.maxCoeff(); }
  std::size_t bytes() const;

  /// Calls function(i) once for each ball i that has a point in common with the box [low, high], until it answers false.
  /// The order depends on balls and box alone.
  template <class Function>
  void for_each_touching(const Vector<D>& low, const Vector<D>& high, Function function) const {
    if (empty() || ((high - origin_).array() < 0).any() || ((low - origin_ - extent_).array() > 0).any())
      return;
    const Cell from = cell_of(low), to = cell_of(high);
    for (Cell cell = from;;) {
      const std::size_t number = number_of(cell);
      for (std::uint32_t entry = offset_[number]; entry < offset_[number + 1]; ++entry) {
        const std::uint32_t i = entries_[entry];
        if (touches(balls_[i], low, high) && is_first(cell, from, balls_[i]) && !function(i)) return;
      }
      if (!advance(cell, from, to)) return;
    }
  }
  bool touches_any(const Vector<D>& low, const Vector<D>& high) const {
    bool any = false;
    for_each_touching(low, high, [&](std::uint32_t) {
      any = true;
      return false;
    });
    return any;
  }

 private:
  using Cell = std::array<std::uint32_t, D>;

  void choose_cells(double edge);
  double entries_wanted() const;
  void fill();

  static bool touches(const Ball<D>& ball, const Vector<D>& low, const Vector<D>& high) {
    const Vector<D> nearest = ball.centre.cwiseMax(low).cwiseMin(high);
    return (nearest - ball.centre).squaredNorm() <= ball.radius * ball.radius;
  }
  /// What lies outside the cells belongs to those at the edge.
  Cell cell_of(const Vector<D>& point) const {
    Cell cell;
    for (int axis = 0; axis < D; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double place = (point[axis] - origin_[axis]) * per_length_[axis];
      cell[a] =
          static_cast<std::uint32_t>(std::max(0.0, std::min(place, static_cast<double>(cells_[a] - 1))));
    }
    return cell;
  }
  std::size_t number_of(const Cell& cell) const {
    std::size_t number = 0;
    for (std::size_t axis = D; axis-- > 0;) number = number * cells_[axis] + cell[axis];
    return number;
  }
  /// Whether this is the first of the query's cells that lists the ball.
  bool is_first(const Cell& cell, const Cell& from, const Ball<D>& ball) const {
    const Cell low = cell_of(ball.centre - Vector<D>::Constant(ball.radius));
    for (std::size_t axis = 0; axis < D; ++axis)
      if (cell[axis] != std::max(low[axis], from[axis])) return false;
    return true;
  }
  /// The next cell between two corners, if there is one.
  static bool advance(Cell& cell, const Cell& from, const Cell& to) {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (cell[axis]++ < to[axis]) return true;
      cell[axis] = from[axis];
    }
    return false;
  }

  std::vector<Ball<D>> balls_;
  Vector<D> origin_ = Vector<D>::Zero(), extent_ = Vector<D>::Zero();
  Vector<D> per_length_ = Vector<D>::Ones();  ///< cells per length
  Cell cells_{};
  std::vector<std::uint32_t> offset_, entries_;
};

extern template class BallIndex<2>;
extern template class BallIndex<3>;

}  // namespace sandglass
