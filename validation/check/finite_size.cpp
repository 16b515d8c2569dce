#include "validation/check/finite_size.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/state.hpp"

#include <cmath>

#include <gsl/gsl_cdf.h>

namespace sandglass {

double self_normalised_factor(int order, double degrees_of_freedom) {
  double factor = 1;
  for (int j = 0; j < order / 2; ++j) factor *= degrees_of_freedom / (degrees_of_freedom + 2 * j);
  return factor;
}

double relative_speed_factor(double degrees_of_freedom) {
  const double k = degrees_of_freedom;
  if (k > 1e6)
    return 1 + 1 / (4 * k);  // the difference of two log-Gammas loses digits; the next term is below 1e-13
  return std::sqrt(k / 2) * std::exp(std::lgamma(k / 2) - std::lgamma((k + 1) / 2));
}

double fixed_count_factor(int dimension, double fraction, double particles) {
  constexpr double step = 1e-3;
  const auto pairs = [&](double nu) { return nu * nu * law::contact_value(dimension, nu); };
  const double curvature =
      (pairs(fraction + step) - 2 * pairs(fraction) + pairs(fraction - step)) / (step * step);
  const double structure = law::long_wave_structure({.dimension = dimension, .fraction = fraction});
  return 1 - structure * curvature / (2 * particles * law::contact_value(dimension, fraction));
}

double collision_rate_factor(double particles, int dimension) {
  return (particles - 1) / particles * relative_speed_factor(dimension * (particles - 1));
}

double component_cumulative(double velocity, double temperature_over_mass, double particles, int dimension) {
  const double k = dimension * (particles - 1);
  const double largest_square = k * temperature_over_mass * (particles - 1) / particles;
  const double share = velocity * velocity / largest_square;
  if (share >= 1) return velocity > 0 ? 1 : 0;
  const double beyond = gsl_cdf_beta_Q(share, 0.5, (k - 1) / 2) / 2;
  return velocity > 0 ? 1 - beyond : beyond;
}

}  // namespace sandglass
