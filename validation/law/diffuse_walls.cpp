#include "validation/law/diffuse_walls.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/state.hpp"
#include "validation/law/transport.hpp"

#include <cmath>
#include <numbers>

namespace sandglass::law {

namespace {
using std::numbers::pi;

/// Particles per area and time that go each way: the streams have equal flux and half of n each in the mean of 1/speed.
double crossing_flux(const Gap& gap) {
  const double low = std::sqrt(gap.low_temperature), high = std::sqrt(gap.high_temperature);
  return number_density(gap.gas) * std::sqrt(2 / (pi * gap.gas.mass)) * low * high / (low + high);
}

Gas at(const Gap& gap, double temperature) {
  Gas gas = gap.gas;
  gas.temperature = temperature;
  return gas;
}

/// Mean free path of the dilute gas.
double free_path(const Gas& gas) { return mean_free_path(gas) * contact_value(gas.dimension, gas.fraction); }
}  // namespace

double emitted_flux(double number_density, double mass, double temperature) {
  return number_density * std::sqrt(temperature / (2 * pi * mass));
}

double emitted_energy(int dimension, double temperature) { return (dimension + 1) * temperature / 2; }

double free_molecular_heat_flux(const Gap& gap) {
  return crossing_flux(gap) * (emitted_energy(gap.gas.dimension, gap.high_temperature) -
                               emitted_energy(gap.gas.dimension, gap.low_temperature));
}

double free_molecular_shear_stress(const Gap& gap) { return crossing_flux(gap) * gap.gas.mass * gap.sliding; }

double continuum_heat_flux(const Gap& gap) {
  const double unit = boltzmann_conductivity(at(gap, 1), SonineOrder::converged);
  return unit * 2 / 3 * (std::pow(gap.high_temperature, 1.5) - std::pow(gap.low_temperature, 1.5)) /
         gap.width;
}

double continuum_shear_stress(const Gap& gap) {
  return boltzmann_shear_viscosity(at(gap, gap.low_temperature), SonineOrder::converged) * gap.sliding /
         gap.width;
}

EndCorrection slip_correction() { return {1, 1.147}; }
EndCorrection jump_correction() { return {1, 1.176}; }

double interpolated_flux(double free_molecular, double continuum, double correction) {
  return 1 / (correction / free_molecular + 1 / continuum);
}

double slip_length_of_spheres(const Gas& gas) { return 1.2540 * std::sqrt(pi) / 2 * free_path(gas); }
double jump_length_of_spheres(const Gas& gas) { return 2.4001 * std::sqrt(pi) / 2 * free_path(gas); }

double slip_length_maxwell(const Gas& gas) {
  return boltzmann_shear_viscosity(gas, SonineOrder::converged) *
         std::sqrt(pi * gas.temperature / 2 / gas.mass) / kinetic_pressure(gas);
}

double jump_length_maxwell(const Gas& gas) {
  return boltzmann_conductivity(gas, SonineOrder::converged) *
         std::sqrt(2 * pi * gas.mass * gas.temperature) / ((gas.dimension + 1) * kinetic_pressure(gas));
}

}  // namespace sandglass::law
