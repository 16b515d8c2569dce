#include "validation/law/state.hpp"

#include "validation/law/contact.hpp"

namespace sandglass::law {

double compressibility_factor(const Gas& gas) {
  return 1 + excluded_fraction(gas) * contact_value(gas.dimension, gas.fraction) * (1 + gas.restitution) / 2;
}

double kinetic_pressure(const Gas& gas) { return number_density(gas) * gas.temperature; }

double collisional_pressure(const Gas& gas) {
  return kinetic_pressure(gas) * (compressibility_factor(gas) - 1);
}

double pressure(const Gas& gas) { return kinetic_pressure(gas) * compressibility_factor(gas); }

double long_wave_structure(const Gas& gas) {
  Gas elastic = gas;
  elastic.restitution = 1;
  const double factor = compressibility_factor(elastic);
  return 1 / (2 * factor - 1 +
              excluded_fraction(gas) * gas.fraction * contact_value_slope(gas.dimension, gas.fraction));
}

double sound_speed(const Gas& gas) {
  Gas elastic = gas;
  elastic.restitution = 1;
  const double factor = compressibility_factor(elastic);
  return thermal_speed(gas) * std::sqrt(1 / long_wave_structure(gas) + 2 * factor * factor / gas.dimension);
}

}  // namespace sandglass::law
