#pragma once

#include "sim/space/grid.hpp"
#include "sim/space/phase.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace sandglass {

/// Shortest vector that a displacement of less than one box stands for in a periodic box.
template <int D>
Vector<D> nearest_image(Vector<D> displacement, const Vector<D>& box) {
  for (int axis = 0; axis < D; ++axis) {
    if (displacement[axis] > box[axis] / 2) displacement[axis] -= box[axis];
    if (displacement[axis] < -box[axis] / 2) displacement[axis] += box[axis];
  }
  return displacement;
}

/// Particles of a periodic box by cells that are at least `reach` wide, for a search of the pairs within reach.
template <int D>
class PairCells {
 public:
  PairCells(std::span<const Phase<D>> particles, const Vector<D>& box, double reach)
      : grid_(box, cells(particles.size(), box, reach)), first_(grid_.size() + 1) {
    std::vector<std::uint32_t> cell(particles.size());
    std::vector<Vector<D>> inside(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
      inside[i] = wrapped(particles[i].position, box);
      ++first_[(cell[i] = grid_.cell_of(inside[i])) + 1];
    }
    std::inclusive_scan(first_.begin(), first_.end(), first_.begin());
    position_.resize(particles.size());
    particle_.resize(particles.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
      const std::uint32_t place = next[cell[i]]++;
      position_[place] = inside[i];
      particle_[place] = i;
    }
  }

  const Grid<D>& grid() const { return grid_; }
  /// Places of the particles of a cell: from begin(cell) to end(cell).
  std::uint32_t begin(std::uint32_t cell) const { return first_[cell]; }
  std::uint32_t end(std::uint32_t cell) const { return first_[cell + 1]; }
  const Vector<D>& position(std::uint32_t place) const { return position_[place]; }
  std::uint32_t particle(std::uint32_t place) const { return particle_[place]; }

  /// Cells after `cell` around it, so that every two neighbours are paired once.
  std::vector<std::uint32_t> neighbours_after(std::uint32_t cell) const {
    std::array<int, D> here;
    std::uint32_t rest = cell;
    for (int axis = 0; axis < D; ++axis) {
      here[static_cast<std::size_t>(axis)] = static_cast<int>(rest % grid_.cells(axis));
      rest /= grid_.cells(axis);
    }
    std::vector<std::uint32_t> list;
    for (int code = power(D) / 2 + 1; code < power(D); ++code) add_neighbour(here, code, list);
    return list;
  }

 private:
  static constexpr int power(int exponent) { return exponent == 0 ? 1 : 3 * power(exponent - 1); }

  /// `code` has the steps -1, 0, 1 along the axes as digits to base 3; an axis of one cell allows no step.
  void add_neighbour(const std::array<int, D>& here, int code, std::vector<std::uint32_t>& list) const {
    std::uint32_t there = 0, stride = 1;
    for (int axis = 0; axis < D; ++axis, code /= 3) {
      const int step = code % 3 - 1, extent = static_cast<int>(grid_.cells(axis));
      if (step != 0 && extent == 1) return;
      there += stride *
               static_cast<std::uint32_t>((here[static_cast<std::size_t>(axis)] + step + extent) % extent);
      stride *= grid_.cells(axis);
    }
    list.push_back(there);
  }

  /// No more cells than particles, roughly; with fewer than three along an axis a cell would be its own neighbour's
  /// neighbour on both sides, so one is taken.
  static std::array<std::uint32_t, D> cells(std::size_t particles, const Vector<D>& box, double reach) {
    const double edge = std::max(
        reach, std::pow(box.prod() / static_cast<double>(std::max<std::size_t>(particles, 1)), 1.0 / D));
    std::array<std::uint32_t, D> cells;
    for (int axis = 0; axis < D; ++axis) {
      const auto wanted = static_cast<std::uint32_t>(std::min(box[axis] / edge, 1e9));
      cells[static_cast<std::size_t>(axis)] = wanted < 3 ? 1 : wanted;
    }
    return cells;
  }

  static Vector<D> wrapped(Vector<D> position, const Vector<D>& box) {
    for (int axis = 0; axis < D; ++axis) position[axis] -= box[axis] * std::floor(position[axis] / box[axis]);
    return position;
  }

  Grid<D> grid_;
  std::vector<std::uint32_t> first_;
  std::vector<Vector<D>> position_;
  std::vector<std::uint32_t> particle_;
};

/// Calls `use(separation, its square, i, j)` for every pair closer than `reach`, at most half the shortest edge of the
/// periodic box; the separation is the vector from particle j to i. The slow twins in the tests look at all pairs.
template <int D, class Use>
void for_each_pair(std::span<const Phase<D>> particles, const Vector<D>& box, double reach, Use use) {
  const PairCells<D> cells(particles, box, reach);
  const auto look_at = [&, limit = reach * reach](std::uint32_t a, std::uint32_t b) {
    const Vector<D> separation = nearest_image<D>(cells.position(a) - cells.position(b), box);
    const double square = separation.squaredNorm();
    if (square < limit) use(separation, square, cells.particle(a), cells.particle(b));
  };
  for (std::uint32_t cell = 0; cell < cells.grid().size(); ++cell) {
    const std::uint32_t begin = cells.begin(cell), end = cells.end(cell);
    if (begin == end) continue;
    for (std::uint32_t i = begin; i < end; ++i)
      for (std::uint32_t j = i + 1; j < end; ++j) look_at(i, j);
    for (std::uint32_t other : cells.neighbours_after(cell))
      for (std::uint32_t j = cells.begin(other); j < cells.end(other); ++j)
        for (std::uint32_t i = begin; i < end; ++i) look_at(i, j);
  }
}

}  // namespace sandglass
