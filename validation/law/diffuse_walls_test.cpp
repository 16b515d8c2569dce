#include "validation/law/diffuse_walls.hpp"

#include "validation/law/quadrature.hpp"
#include "validation/law/transport.hpp"

#include <gtest/gtest.h>

namespace sandglass::law::diffuse_walls_test {
namespace {

using quadrature::integral;
using std::numbers::pi;

Gap gap_of(int dimension) {
  const Gas gas{.dimension = dimension, .diameter = 0.02, .mass = 1.3, .temperature = 1.7, .fraction = 1e-3};
  return {gas, 0.8, 1.7, 1.7, 0.6};
}

double maxwellian(double mass, double temperature, double v) {
  return std::sqrt(mass / (2 * pi * temperature)) * std::exp(-mass * v * v / (2 * temperature));
}

/// Mean of a function of the normal velocity over what leaves a wall, from the definition of a flux.
double leaving(double mass, double temperature, const std::function<double(double)>& value) {
  const double fastest = 12 * std::sqrt(temperature / mass);
  return integral([&](double v) { return v * maxwellian(mass, temperature, v) * value(v); }, 0, fastest);
}

TEST(Emission, IsTheFluxOfAMaxwellian) {
  const double flux = leaving(1.3, 1.7, [](double) { return 1; });
  EXPECT_NEAR(emitted_flux(0.4, 1.3, 1.7), 0.4 * flux, 1e-9);
  const double normal = leaving(1.3, 1.7, [](double v) { return 1.3 * v * v / 2; }) / flux;
  for (int dimension : {2, 3})
    EXPECT_NEAR(emitted_energy(dimension, 1.7), normal + (dimension - 1) * 1.7 / 2, 1e-8);
}

/// Two streams of densities a and b, equal fluxes, a + b twice the mean of their half spaces: by the definitions above.
TEST(FreeMolecular, FluxesAreThoseOfTwoStreams) {
  for (int dimension : {2, 3}) {
    Gap gap = gap_of(dimension);
    gap.low_temperature = 0.9;
    gap.high_temperature = 2.3;
    const double ratio = std::sqrt(0.9 / 2.3);  // density of the hot stream over the cold one's
    const double cold = 2 * number_density(gap.gas) / (1 + ratio);
    const double flux = emitted_flux(cold, 1.3, 0.9);
    EXPECT_NEAR(flux, emitted_flux(cold * ratio, 1.3, 2.3), 1e-12 * flux);
    const double heat = flux * (emitted_energy(dimension, 2.3) - emitted_energy(dimension, 0.9));
    EXPECT_NEAR(free_molecular_heat_flux(gap) / heat, 1, 1e-12);
    EXPECT_NEAR(free_molecular_shear_stress(gap) / (flux * 1.3 * 0.6), 1, 1e-12);
  }
}

TEST(Continuum, HeatIsTheIntegralOfTheConductivity) {
  for (int dimension : {2, 3}) {
    Gap gap = gap_of(dimension);
    gap.low_temperature = 0.9;
    gap.high_temperature = 2.3;
    const auto conductivity = [&](double temperature) {
      Gas gas = gap.gas;
      gas.temperature = temperature;
      return boltzmann_conductivity(gas, SonineOrder::converged);
    };
    const double heat = integral(conductivity, 0.9, 2.3) / 0.8;
    EXPECT_NEAR(continuum_heat_flux(gap) / heat, 1, 1e-9);
    std::swap(gap.low_temperature, gap.high_temperature);
    EXPECT_NEAR(continuum_heat_flux(gap) / heat, -1, 1e-9);
  }
}

/// Maxwell's argument: half of the flux of the bulk is carried by what arrives, so that the particles that arrive bring
/// q/2 more than a gas at rest at the temperature of the bulk, and the wall must lose q in all.
TEST(Maxwell, LengthsFollowFromHalfTheFlux) {
  for (int dimension : {2, 3}) {
    const Gas gas = gap_of(dimension).gas;
    const double gradient = 1e-3;
    const double arriving = emitted_flux(number_density(gas), gas.mass, gas.temperature);
    const double heat = boltzmann_conductivity(gas, SonineOrder::converged) * gradient;
    const double jump = heat / 2 / (arriving * emitted_energy(dimension, 1));
    EXPECT_NEAR(jump_length_maxwell(gas) * gradient / jump, 1, 1e-12);
    const double stress = boltzmann_shear_viscosity(gas, SonineOrder::converged) * gradient;
    const double slip = stress / 2 / (arriving * gas.mass);
    EXPECT_NEAR(slip_length_maxwell(gas) * gradient / slip, 1, 1e-12);
  }
}

/// Small differences between the walls: the interpolation with Maxwell's lengths is the bulk with both ends longer.
TEST(Interpolation, HasBothLimits) {
  for (int dimension : {2, 3}) {
    Gap gap = gap_of(dimension);
    gap.high_temperature *= 1 + 1e-6;
    for (const double width : {1e-4, 1.0, 1e4}) {
      gap.width = width;
      const double heat = interpolated_flux(free_molecular_heat_flux(gap), continuum_heat_flux(gap), 1);
      const double longer = width + 2 * jump_length_maxwell(gap.gas);
      EXPECT_NEAR(heat / (continuum_heat_flux(gap) * width / longer), 1, 1e-5);
      const double stress =
          interpolated_flux(free_molecular_shear_stress(gap), continuum_shear_stress(gap), 1);
      const double wider = width + 2 * slip_length_maxwell(gap.gas);
      EXPECT_NEAR(stress / (continuum_shear_stress(gap) * width / wider), 1, 1e-5);
    }
    gap.width = 1e-9;
    EXPECT_NEAR(interpolated_flux(free_molecular_heat_flux(gap), continuum_heat_flux(gap), 1) /
                    free_molecular_heat_flux(gap),
                1, 1e-6);
  }
}

/// Plane Couette flow of the BGK gas, stress over that of free flight at gaps of delta eta sqrt(2T/m)/(nT): Willis 1962 and
/// later tables (Cercignani 1988). What the ends must count for lies between the two limits, and grows towards the slip.
TEST(Interpolation, CorrectionLiesBetweenItsLimits) {
  double before = 1;
  for (const auto& [delta, stress] : {std::pair{0.1, 0.9258}, {1.0, 0.6008}, {10.0, 0.1474}}) {
    const double correction = (1 / stress - delta / std::sqrt(pi));
    EXPECT_GT(correction, before) << delta;
    EXPECT_LT(correction, slip_correction().most) << delta;
    before = correction;
  }
}

TEST(Spheres, LengthsLieWithinTheCorrections) {
  const Gas gas = gap_of(3).gas;
  const double slip = slip_length_of_spheres(gas) / slip_length_maxwell(gas);
  const double jump = jump_length_of_spheres(gas) / jump_length_maxwell(gas);
  EXPECT_NEAR(slip, 1.114, 5e-4);  // 0.98737 2/sqrt(pi), Siewert 2003
  EXPECT_NEAR(jump, 1.127, 5e-4);
  EXPECT_LT(slip, slip_correction().most);
  EXPECT_LT(jump, jump_correction().most);
}

}  // namespace
}  // namespace sandglass::law::diffuse_walls_test
