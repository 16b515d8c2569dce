#pragma once

#include <cstring>

namespace sandglass {

template <int D>
struct LaneTypes;
template <>
struct LaneTypes<2> {
  using Real = double __attribute__((vector_size(16)));
  using Whole = int __attribute__((vector_size(8)));
};
template <>
struct LaneTypes<3> {
  using Real = double __attribute__((vector_size(32)));
  using Whole = int __attribute__((vector_size(16)));
};

/// The components of a vector side by side in one register; three of them leave a fourth lane without meaning.
template <int D>
struct Lanes : LaneTypes<D> {
  using typename LaneTypes<D>::Real;

  /// Reads a whole register, for a vector of three one double more than it has: memory must go on behind it.
  static Real load(const double* components) {
    Real lanes;
    std::memcpy(&lanes, components, sizeof lanes);
    return lanes;
  }
  static void store(double* components, const Real& lanes) {
    std::memcpy(components, &lanes, D * sizeof(double));
  }

  /// The lane without meaning gets `rest`.
  template <class Source>
  static Real from(const Source& components, double rest) {
    Real lanes = Real{} + rest;
    for (int axis = 0; axis < D; ++axis) lanes[axis] = components[axis];
    return lanes;
  }
};

}  // namespace sandglass
