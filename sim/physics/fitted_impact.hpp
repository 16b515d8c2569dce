#pragma once

#include "sim/physics/collision.hpp"

namespace sandglass {

/// Impact parameters, in diameters, whose density over the cross-section is a/(1 - c b^2) (Mueller 2001, Eq. 3.18);
/// c below 1, the limit c = 0 is molecular chaos, above it grazing collisions are more frequent. By inversion of the
/// distribution: b = tanh(z artanh s)/s in 2D with s = sqrt(c) and z uniform in (-1, 1), b^2 = (1 - (1 - c)^u)/c in 3D
/// with u uniform in (0, 1).
struct FittedImpact {
  double c = 0;

  Vector<1> draw(const Vector<1>& uniform) const {
    const double root = std::sqrt(std::abs(c)), z = uniform[0];
    if (root < kUniform) return uniform;
    return Vector<1>(c > 0 ? std::tanh(z * std::atanh(root)) / root : std::tan(z * std::atan(root)) / root);
  }
  Vector<2> draw(const Vector<2>& uniform) const {
    const double u = uniform.squaredNorm();
    if (std::abs(c) < kUniform * kUniform || u == 0) return uniform;
    const double square = -std::expm1(u * std::log1p(-c)) / c;
    return uniform * std::sqrt(std::min(square, 1.0) / u);
  }

 private:
  static constexpr double kUniform = 1e-4;  ///< below, the distribution is uniform to rounding of c
};

}  // namespace sandglass
