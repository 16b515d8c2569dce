#pragma once

#include <algorithm>
#include <cmath>

namespace sandglass {

/// E[max(v, 0)] of a normal distribution of mean `stream` and width `thermal`: particles of number density one that pass a
/// plane upwards, per area and time. Of a beam without a width what its velocity says.
inline double maxwellian_flux(double stream, double thermal) {
  if (!(thermal > 0)) return std::max(0.0, stream);
  const double a = stream / thermal;
  return std::max(
      0.0, thermal * std::exp(-0.5 * a * a) / std::sqrt(2 * M_PI) + stream * 0.5 * std::erfc(-a * M_SQRT1_2));
}

}  // namespace sandglass
