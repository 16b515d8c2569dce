#include "validation/law/transport.hpp"

#include "validation/law/contact.hpp"

namespace sandglass::law {

using std::numbers::pi;

namespace {
double converged_factor(int dimension) { return dimension == 2 ? 1.022 : 1.016; }
}  // namespace

double boltzmann_shear_viscosity(const Gas& gas, SonineOrder order) {
  const double momentum = std::sqrt(gas.mass * gas.temperature / pi);
  const double first =
      gas.dimension == 2 ? momentum / (2 * gas.diameter) : 5 * momentum / (16 * gas.diameter * gas.diameter);
  return order == SonineOrder::first ? first : first * converged_factor(gas.dimension);
}

double boltzmann_conductivity(const Gas& gas, SonineOrder order) {
  const double dimension = gas.dimension;
  const double first = (dimension + 2) / 2 * dimension / (dimension - 1) *
                       boltzmann_shear_viscosity(gas, SonineOrder::first) / gas.mass;
  if (order == SonineOrder::first) return first;
  return first * (gas.dimension == 2 ? 1.0297 : 1.0252);
}

double enskog_bulk_viscosity(const Gas& gas) {
  const double factor = gas.dimension == 2 ? 16 / pi : 256 / (5 * pi);
  return factor * gas.fraction * gas.fraction * contact_value(gas.dimension, gas.fraction) *
         boltzmann_shear_viscosity(gas, SonineOrder::first);
}

double enskog_shear_viscosity(const Gas& gas, SonineOrder order) {
  const double contact = contact_value(gas.dimension, gas.fraction);
  const double transfer = 1 + 2 * excluded_fraction(gas) * contact / (gas.dimension + 2);
  return boltzmann_shear_viscosity(gas, order) / contact * transfer * transfer +
         enskog_bulk_viscosity(gas) * gas.dimension / (gas.dimension + 2);
}

double enskog_kinematic_viscosity(const Gas& gas, SonineOrder order) {
  return enskog_shear_viscosity(gas, order) / (gas.mass * number_density(gas));
}

}  // namespace sandglass::law
