#pragma once

#include "sim/space/quad.hpp"

namespace sandglass::event_driven {

/// Time until two spheres in free flight touch, from their separation r and relative velocity u: `along` = r.u, `gap` =
/// r^2 - (sum of radii)^2, `speed` = u^2. Infinity if they never do. Spheres that overlap collide at once when they
/// approach and are left alone when they recede (Bannerman, Strobl, Formella & Poeschel 2014); the root is taken in the
/// form that does not cancel. For one pair or four.
template <class Real>
Real contact_time(Real along, Real gap, Real speed) {
  const Real discriminant = along * along - speed * gap;
  const Real root = square_root(larger(discriminant, Real{}));
  const Real time = larger(gap, Real{}) / (root - along);
  return (along < 0) & ((discriminant >= 0) | (gap <= 0)) ? time : Real{} + HUGE_VAL;
}

}  // namespace sandglass::event_driven
