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

  /// `position` lies in the box, edges included.
  std::size_t bin_of(const Vector<D>& position, const Vector<D>& box) const {
    std::size_t bin = 0;
    for (int axis = 0; axis < D; ++axis) {
      const std::size_t extent = extents[static_cast<std::size_t>(axis)];
      const auto along = static_cast<std::size_t>(position[axis] / box[axis] * static_cast<double>(extent));
      bin = bin * extent + std::min(along, extent - 1);
    }
    return bin;
  }
};

}  // namespace sandglass
