#pragma once

#include "sim/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sandglass {

/// Regular cells over a box whose low corner is the origin. Cell numbers run fastest along axis 0.
template <int D>
class Grid {
 public:
  Grid(const Vector<D>& box, const std::array<std::uint32_t, D>& cells) : box_(box), cells_(cells) {
    for (int axis = 0; axis < D; ++axis) per_length_[axis] = cells_[index(axis)] / box_[axis];
  }

  const Vector<D>& box() const { return box_; }
  std::uint32_t cells(int axis) const { return cells_[index(axis)]; }
  double cells_per_length(int axis) const { return per_length_[axis]; }
  std::uint32_t size() const {
    std::uint32_t product = 1;
    for (std::uint32_t extent : cells_) product *= extent;
    return product;
  }
  double cell_volume() const { return box_.prod() / size(); }

  /// The far edge belongs to the last cell; what a moving wall has let out of the box, to the cell at the edge.
  std::uint32_t cell_of(const Vector<D>& position) const {
    std::uint32_t cell = coordinate(position, D - 1);
    for (int axis = D - 2; axis >= 0; --axis) cell = cell * cells_[index(axis)] + coordinate(position, axis);
    return cell;
  }

  /// The nearest position of this cell: for it cell_of() gives the cell, to the last digit.
  void put_into(std::uint32_t cell, Vector<D>& position) const {
    if (holds(position) && cell_of(position) == cell) return;
    for (int axis = 0; axis < D; ++axis) {
      const std::uint32_t place = cell % cells_[index(axis)];
      cell /= cells_[index(axis)];
      const double edge = 1 / per_length_[axis];
      double& x = position[axis];
      x = std::min(std::clamp(x, place * edge, (place + 1) * edge), box_[axis]);
      while (coordinate(position, axis) < place) x = std::nextafter(x, HUGE_VAL);
      while (coordinate(position, axis) > place) x = std::nextafter(x, -HUGE_VAL);
    }
  }

 private:
  bool holds(const Vector<D>& position) const {
    return (position.array() >= 0).all() && (position.array() <= box_.array()).all();
  }
  static std::size_t index(int axis) { return static_cast<std::size_t>(axis); }
  std::uint32_t coordinate(const Vector<D>& position, int axis) const {
    const double coordinate = std::max(0.0, position[axis] * per_length_[axis]);
    return static_cast<std::uint32_t>(std::min(coordinate, static_cast<double>(cells_[index(axis)] - 1)));
  }

  Vector<D> box_, per_length_;
  std::array<std::uint32_t, D> cells_;
};

}  // namespace sandglass
