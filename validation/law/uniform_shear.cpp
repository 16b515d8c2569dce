#include "validation/law/uniform_shear.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/state.hpp"
#include "validation/law/transport.hpp"

namespace sandglass::law {

namespace {
/// Rates over nT/eta0.
struct Rates {
  double cooling;   ///< z
  double exchange;  ///< b: relaxation of the stress beyond cooling
};

Rates rates_of(int dimension, double restitution) {
  const double cooling = (dimension + 2) * (1 - restitution * restitution) / (4 * dimension);
  return {cooling, stress_relaxation_ratio(dimension, restitution) - cooling};
}

Gas at_temperature(Gas gas, double temperature) {
  gas.temperature = temperature;
  return gas;
}

double dissipation_rate(const Gas& gas) {
  return gas.dimension / 2.0 * number_density(gas) * gas.temperature * cooling_rate(gas);
}
}  // namespace

double stress_relaxation_ratio(int dimension, double restitution) {
  const double half = (1 + restitution) / 2;
  return dimension == 2 ? half * (5 - 3 * half) / 2 : half * (2 - half);
}

double dilute_shear_rate(int dimension, double restitution) {
  const auto [z, b] = rates_of(dimension, restitution);
  return std::sqrt(dimension * z / (2 * b)) * (b + z);
}

ReducedStress dilute_shear_stress(int dimension, double restitution) {
  const auto [z, b] = rates_of(dimension, restitution);
  return {(b + dimension * z) / (b + z), b / (b + z), std::sqrt(dimension * b * z / 2) / (b + z)};
}

double dilute_shear_temperature(const Gas& gas, double rate) {
  const Gas unit = at_temperature(gas, 1);
  const double relaxation = number_density(gas) / boltzmann_shear_viscosity(unit, SonineOrder::first);
  return std::pow(rate / (relaxation * dilute_shear_rate(gas.dimension, gas.restitution)), 2);
}

double inelastic_shear_viscosity(const Gas& gas) {
  const double half = (1 + gas.restitution) / 2, contact = contact_value(gas.dimension, gas.fraction);
  const double transfer = 2 * excluded_fraction(gas) * contact * half / (gas.dimension + 2);
  return boltzmann_shear_viscosity(gas, SonineOrder::first) /
             (contact * stress_relaxation_ratio(gas.dimension, gas.restitution)) * (1 + transfer) *
             (1 + transfer * (3 * half - 2)) +
         half * enskog_bulk_viscosity(gas) * gas.dimension / (gas.dimension + 2);
}

double shear_temperature(const Gas& gas, double rate) {
  const Gas unit = at_temperature(gas, 1);  // heating goes as sqrt(T), dissipation as T sqrt(T)
  return inelastic_shear_viscosity(unit) * rate * rate / dissipation_rate(unit);
}

double shear_stress(const Gas& gas, double rate) {
  return rate * inelastic_shear_viscosity(at_temperature(gas, shear_temperature(gas, rate)));
}

double shear_pressure(const Gas& gas, double rate) {
  return pressure(at_temperature(gas, shear_temperature(gas, rate)));
}

}  // namespace sandglass::law
