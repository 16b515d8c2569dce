#pragma once

#include <Eigen/Core>

namespace sandglass {

/// Point, velocity or direction in D dimensions.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

/// Angular velocity: one component for disks, three for spheres.
template <int D>
using Spin = Eigen::Matrix<double, D == 2 ? 1 : 3, 1>;

}  // namespace sandglass
