#include "validation/law/transport.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"

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

double monte_carlo_shear_viscosity(const Gas& gas, const CellScheme& scheme, SonineOrder order) {
  const double density = number_density(gas), dimension = gas.dimension;
  const double carried = scheme.along * excluded_fraction(gas) * scheme.contact;  // p_c/nT
  const double returned = gas.dimension == 2 ? 0 : -carried / 5;
  const double steps =
      scheme.collisions_per_step * (gas.dimension == 2 ? 1 : 0.8);  // of stress, relaxation times
  const double kinetic = boltzmann_shear_viscosity(gas, order) / scheme.contact * (1 + steps * steps / 12);
  const double rate = collision_rate(gas) / contact_value(gas.dimension, gas.fraction) * scheme.contact;
  const double squares =
      scheme.along * scheme.along + scheme.random * scheme.random + scheme.cell_edge * scheme.cell_edge / 3;
  return kinetic * (1 + carried) * (1 + returned) +
         gas.mass * density * rate / 2 * gas.diameter * gas.diameter / dimension * squares;
}

double monte_carlo_kinematic_viscosity(const Gas& gas, const CellScheme& scheme, SonineOrder order) {
  return monte_carlo_shear_viscosity(gas, scheme, order) / (gas.mass * number_density(gas));
}

}  // namespace sandglass::law
