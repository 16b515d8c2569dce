#include "validation/law/moments.hpp"

#include "sim/base/error.hpp"

#include <cmath>

namespace sandglass::law {

double maxwell_component_moment(int order, double variance) {
  SANDGLASS_EXPECT(order >= 0);
  if (order % 2 != 0) return 0;
  double moment = 1;
  for (int k = 1; k < order; k += 2) moment *= k * variance;
  return moment;
}

double maxwell_speed_moment(int dimension, int order, double variance) {
  SANDGLASS_EXPECT(order >= 0);
  return std::pow(2 * variance, order / 2.0) * std::tgamma((dimension + order) / 2.0) /
         std::tgamma(dimension / 2.0);
}

double sonine_moment_factor(int order, double a2) {
  SANDGLASS_EXPECT(order >= 0 && order % 2 == 0);
  const int k = order / 2;
  return 1 + a2 * k * (k - 1) / 2;
}

}  // namespace sandglass::law
