#pragma once

#include <algorithm>
#include <cmath>

namespace sandglass::event_driven {

/// Time until two spheres in free flight touch, from their separation r and relative velocity u: `along` = r.u, `gap` =
/// r^2 - (sum of radii)^2, `speed` = u^2. Infinity if they never do. Spheres that overlap collide at once when they
/// approach and are left alone when they recede (Bannerman, Strobl, Formella & Poeschel 2014); the root is taken in the
/// form that does not cancel. Without branches, for loops over many pairs.
inline double contact_time(double along, double gap, double speed) {
  const double discriminant = along * along - speed * gap;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double time = std::max(gap, 0.0) / (root - along);
  return (along < 0) & ((discriminant >= 0) | (gap <= 0)) ? time : HUGE_VAL;
}

}  // namespace sandglass::event_driven
