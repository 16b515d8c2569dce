#include "validation/law/catalogue.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/transport.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kViscosityUnits = "mass length^(2-dimension) time^-1";
constexpr const char* kConductivityUnits = "length^(2-dimension) time^-1";
constexpr const char* kDiluteSource = "Gass 1971 (disks); Chapman & Cowling 1970, ch. 10 (spheres)";
constexpr const char* kEnskogSource = "Gass 1971 (disks); Chapman & Cowling 1970, sec. 16.5 (spheres)";
constexpr const char* kExact = "elastic gas near equilibrium, no Sonine expansion";
constexpr const char* kFirst = "elastic gas near equilibrium, first Sonine order";
constexpr const char* kConverged = "elastic gas near equilibrium, all Sonine orders to 0.05%";

using Coefficient = double (*)(const Gas&, SonineOrder);

std::function<double(const Arguments&)> to_order(Coefficient coefficient, SonineOrder order) {
  return [coefficient, order](const Arguments& given) { return coefficient(gas_from(given), order); };
}

Law dilute_law(std::string name, std::string summary, std::string units, std::string validity,
               std::function<double(const Arguments&)> evaluate) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = kDiluteSource,
          .units = std::move(units),
          .validity = std::move(validity) + ", fraction near 0",
          .parameters = {temperature(), mass(), diameter(), dimension()},
          .evaluate = std::move(evaluate)};
}

Law enskog_law(std::string name, std::string summary, std::string units, std::string validity,
               std::function<double(const Arguments&)> evaluate) {
  return {
      .name = std::move(name),
      .summary = std::move(summary),
      .source = kEnskogSource,
      .units = std::move(units),
      .validity = std::move(validity) + "; Enskog theory, area fraction below 0.5, volume fraction below 0.4",
      .parameters = with_fraction({temperature(), mass(), diameter()}),
      .evaluate = std::move(evaluate)};
}

Law monte_carlo_law() {
  const Parameter contact{
      "contact-factor", "1", "collision rate over that of the dilute gas", 1e-9, 1e9, 1.0};
  const Parameter along{"offset", "diameters", "displacement of partners along their momentum change",
                        0,        1e3,         1.0};
  const Parameter random{"random-offset", "diameters", "displacement in a random direction", 0, 1e3, 0.0};
  const Parameter edge{"cell-edge", "diameters", "of a cell, across the flow", 0, 1e9, 0.0};
  const Parameter step{"collisions-per-step", "1", "collisions of a particle in a time step", 0, 1e3, 0.0};
  Law law = enskog_law(
      "monte-carlo-kinematic-viscosity",
      "shear viscosity over mass density where partners collide in one place and are displaced",
      "length^2/time", "elastic gas near equilibrium, all Sonine orders of the part that flight carries",
      [](const Arguments& given) {
        const CellScheme scheme{given.at("contact-factor"), given.at("offset"), given.at("random-offset"),
                                given.at("cell-edge"), given.at("collisions-per-step")};
        return monte_carlo_kinematic_viscosity(gas_from(given), scheme, SonineOrder::converged);
      });
  law.source = "docs/theory.md; cells: Alexander, Garcia & Alder 1998; steps: Hadjiconstantinou 2000";
  law.parameters.insert(law.parameters.end(), {contact, along, random, edge, step});
  return law;
}
}  // namespace

std::vector<Law> transport_laws() {
  using enum SonineOrder;
  const std::string shear_dilute = "shear viscosity of the dilute gas";
  const std::string shear = "shear viscosity of the Enskog gas";
  const std::string kinematic = "shear viscosity over mass density; a shear wave decays at k^2 times it";
  const std::string conductivity = "heat conductivity of the dilute gas, temperature as an energy";
  return {dilute_law("boltzmann-shear-viscosity", shear_dilute, kViscosityUnits, kFirst,
                     to_order(boltzmann_shear_viscosity, first)),
          dilute_law("boltzmann-shear-viscosity-converged", shear_dilute, kViscosityUnits, kConverged,
                     to_order(boltzmann_shear_viscosity, converged)),
          dilute_law("boltzmann-conductivity", conductivity, kConductivityUnits, kFirst,
                     to_order(boltzmann_conductivity, first)),
          dilute_law("boltzmann-conductivity-converged", conductivity, kConductivityUnits, kConverged,
                     to_order(boltzmann_conductivity, converged)),
          enskog_law("enskog-shear-viscosity", shear, kViscosityUnits, kFirst,
                     to_order(enskog_shear_viscosity, first)),
          enskog_law("enskog-shear-viscosity-converged", shear, kViscosityUnits, kConverged,
                     to_order(enskog_shear_viscosity, converged)),
          enskog_law("enskog-bulk-viscosity", "bulk viscosity of the Enskog gas", kViscosityUnits, kExact,
                     of_gas(enskog_bulk_viscosity)),
          enskog_law("kinematic-viscosity", kinematic, "length^2/time", kFirst,
                     to_order(enskog_kinematic_viscosity, first)),
          enskog_law("kinematic-viscosity-converged", kinematic, "length^2/time", kConverged,
                     to_order(enskog_kinematic_viscosity, converged)),
          monte_carlo_law()};
}

}  // namespace sandglass::law
