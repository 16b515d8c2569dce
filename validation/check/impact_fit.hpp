#pragma once

#include "sim/base/statistics.hpp"

#include <span>

namespace sandglass {

/// c of the impact distribution a/(1 - c b^2) (law/impact.hpp) that makes the counts of independent collisions in bins
/// most likely, c from -100 to below 1. `edges` of b, one more than counts: from -1 to 1 for disks, from 0 to 1 for
/// spheres. The error follows from the curvature of the likelihood. Throws InputError without counts, or when the
/// largest likelihood lies at the end of the range.
Mean fit_impact_coefficient(int dimension, std::span<const double> edges, std::span<const double> counts);

}  // namespace sandglass
