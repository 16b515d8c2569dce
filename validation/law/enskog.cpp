#include "validation/law/enskog.hpp"

#include "validation/law/contact.hpp"

namespace sandglass::law {

using std::numbers::pi;

double collision_rate(const Gas& gas) {
  const double surface = gas.dimension == 2 ? 2 * gas.diameter : 4 * gas.diameter * gas.diameter;
  return surface * std::sqrt(pi) * number_density(gas) * contact_value(gas.dimension, gas.fraction) *
         thermal_speed(gas);
}

double mean_speed(const Gas& gas) {
  return thermal_speed(gas) * std::sqrt(gas.dimension == 2 ? pi / 2 : 8 / pi);
}

double mean_free_path(const Gas& gas) { return mean_speed(gas) / collision_rate(gas); }

}  // namespace sandglass::law
