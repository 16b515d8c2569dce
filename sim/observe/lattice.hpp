#pragma once

#include "sim/base/vector.hpp"

#include <algorithm>
#include <vector>

namespace sandglass {

/// Bins of a regular grid over the box; numbers run fastest along the last axis, as in an array.
template <int D>
struct Lattice {
  std::vector<std::size_t> extents;

  std::size_t size() const {
    std::size_t product = 1;
    for (std::size_t extent : extents) product *= extent;
    return product;
  }

  /// What a moving wall has let out of the box belongs to the bin at the edge.
  std::size_t bin_of(const Vector<D>& position, const Vector<D>& box) const {
    std::size_t bin = 0;
    for (int axis = 0; axis < D; ++axis) {
      const std::size_t extent = extents[static_cast<std::size_t>(axis)];
      const double along = std::max(0.0, position[axis] / box[axis] * static_cast<double>(extent));
      bin = bin * extent + static_cast<std::size_t>(std::min(along, static_cast<double>(extent - 1)));
    }
    return bin;
  }
};

}  // namespace sandglass
