#pragma once

#include <cmath>

namespace sandglass {

/// Coefficient of normal restitution at the normal speed v of approach: constant, or with a reference speed v0
///   r(v) = 1 - (1 - r0) (v / v0)^(3/4) for v < v0, r0 above
/// (Bizon, Shattuck, Swift, McCormick & Swinney 1998, Phys. Rev. Lett. 80, 57). It goes to 1 at rest, which prevents
/// inelastic collapse.
struct Restitution {
  double value = 1;            ///< r0, in [0, 1]
  double reference_speed = 0;  ///< v0; 0: constant

  double operator()(double normal_speed) const {
    if (normal_speed >= reference_speed) return value;
    const double ratio = normal_speed / reference_speed;
    return 1 - (1 - value) * std::sqrt(ratio * std::sqrt(ratio));
  }
};

}  // namespace sandglass
