#pragma once

#include "sim/base/vector.hpp"

namespace sandglass {

/// Earliest t >= 0 at which a point that flies as x + v t + g t^2 / 2 hits a fixed disk or sphere of radius `reach` (the
/// sum of the radii) about the origin from outside; infinity if never. Overlapping and approaching is now; overlapping and
/// receding is no event (Bannerman, Strobl, Formella & Poeschel 2014).
template <int D>
double time_to_obstacle(const Vector<D>& x, const Vector<D>& v, const Vector<D>& g, double reach);

}  // namespace sandglass
