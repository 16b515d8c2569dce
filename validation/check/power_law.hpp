#pragma once

#include <span>
#include <vector>

namespace sandglass {

/// A straight line through ln y against ln x, and how much better a parabola is. The errors follow from the standard
/// errors of y, not from the scatter: judge that by chi square.
struct PowerLawFit {
  double exponent = 0, exponent_error = 0;
  double log_prefactor = 0;  ///< ln y at ln x = 0
  double curvature = 0,
         curvature_error = 0;     ///< d(exponent)/d(ln x) of the parabola; needs three different x
  double chi_square = 0;          ///< of the line
  double degrees_of_freedom = 0;  ///< points - 2
};

/// Positive x and y, at least three different x, standard errors above zero and well below y.
PowerLawFit fit_power_law(std::span<const double> x, std::span<const double> y,
                          std::span<const double> standard_error);

/// Slope from a point to the next, at the geometric mean of their x.
struct LocalExponents {
  std::vector<double> x, exponent, error;  ///< neighbours share a point: their errors are not independent
};
LocalExponents local_exponents(std::span<const double> x, std::span<const double> y,
                               std::span<const double> standard_error);

}  // namespace sandglass
