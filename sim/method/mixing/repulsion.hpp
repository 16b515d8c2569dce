#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace sandglass::mixing {

/// Whole powers by squaring: the exponents of the source are whole numbers.
inline double power(double base, std::uint64_t exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

/// Repulsion between two particles (Greenspan 1972, 2.11 and ACCEL of its listing): particle j is accelerated by
/// alpha m_i (x_j - x_i) / [(r + xi)^p ((r + xi)/d)^beta], the second factor for r < d only, up to a cutoff.
struct Repulsion {
  double coefficient = 1;                                   ///< alpha
  double softening_length = 0;                              ///< xi
  std::uint64_t exponent = 2;                               ///< p
  std::uint64_t core_exponent = 0;                          ///< beta
  double diameter = 1;                                      ///< d: the core begins there
  double cutoff = std::numeric_limits<double>::infinity();  ///< none from this distance on

  /// Acceleration over separation and mass of the other particle; the distance is below the cutoff.
  double per_separation(double distance) const {
    const double softened = distance + softening_length;
    double divisor = power(softened, exponent);
    if (distance < diameter) divisor *= power(softened / diameter, core_exponent);
    return coefficient / divisor;
  }
};

}  // namespace sandglass::mixing
