#pragma once

#include <Eigen/Core>

namespace sandglass {

/// Point, velocity or direction in D dimensions.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

}  // namespace sandglass
