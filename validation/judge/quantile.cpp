#include "validation/judge/quantile.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>

namespace sandglass {

double shared_probability(double probability, int comparisons) {
  return -std::expm1(std::log1p(-probability) / comparisons);
}

double two_sided_quantile(double probability, double degrees_of_freedom) {
  if (degrees_of_freedom > 0) return gsl_cdf_tdist_Qinv(probability / 2, degrees_of_freedom);
  return gsl_cdf_ugaussian_Qinv(probability / 2);
}

}  // namespace sandglass
