#include "validation/law/catalogue.hpp"
#include "validation/law/diffuse_walls.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kEnergy = "mass length^2 time^-2";
constexpr const char* kHeatUnits = "mass length^(3-dimension) time^-3";
constexpr const char* kStressUnits = "mass length^(2-dimension) time^-2";
constexpr const char* kFree = "diffuse walls, mean free path much longer than the gap";
constexpr const char* kDense = "diffuse walls, mean free path much shorter than the gap, dilute gas";

Parameter width() { return with_fallback(positive("width", "length", "between the walls"), 1); }
Parameter sliding() {
  return any_real("sliding-velocity", "length/time", "of one wall along itself, less that of the other");
}
Parameter low() { return positive("first-wall-temperature", kEnergy, "granular temperature of one wall"); }
Parameter high() { return positive("second-wall-temperature", kEnergy, "granular temperature of the other"); }

Gap gap_from(const Arguments& given) {
  const auto value_or = [&given](const char* name, double fallback) {
    const auto found = given.find(name);
    return found == given.end() ? fallback : found->second;
  };
  const double alike = value_or("temperature", 1);
  return {gas_from(given), value_or("width", 1), value_or("first-wall-temperature", alike),
          value_or("second-wall-temperature", alike), value_or("sliding-velocity", 0)};
}

std::function<double(const Arguments&)> of_gap(double (*result)(const Gap&)) {
  return [result](const Arguments& given) { return result(gap_from(given)); };
}

Law emission_law() {
  return {.name = "wall-emission-energy",
          .summary = "mean kinetic energy of the particles that a thermal wall at rest sends off",
          .source = "flux-weighted Maxwellian; Kennard 1938, sec. 176",
          .units = kEnergy,
          .validity = "any gas; exact",
          .parameters = {temperature(), dimension()},
          .evaluate = [](const Arguments& given) {
            return emitted_energy(static_cast<int>(given.at("dimension")), given.at("temperature"));
          }};
}

Law heat_law(std::string name, std::string source, std::string validity, std::vector<Parameter> parameters,
             double (*result)(const Gap&)) {
  return {.name = std::move(name),
          .summary = "heat per area and time between two thermal walls",
          .source = std::move(source),
          .units = kHeatUnits,
          .validity = std::move(validity),
          .parameters = std::move(parameters),
          .evaluate = of_gap(result)};
}

Law stress_law(std::string name, std::string source, std::string validity, std::vector<Parameter> parameters,
               double (*result)(const Gap&)) {
  return {.name = std::move(name),
          .summary = "shear stress between two thermal walls, one of which slides along",
          .source = std::move(source),
          .units = kStressUnits,
          .validity = std::move(validity),
          .parameters = std::move(parameters),
          .evaluate = of_gap(result)};
}

Law length_law(std::string name, std::string summary, std::string source, std::string validity,
               double (*result)(const Gas&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = "length",
          .validity = std::move(validity),
          .parameters = with_fraction({temperature(), mass(), diameter()}),
          .evaluate = of_gas(result)};
}

Law sphere_law(std::string name, std::string summary, double (*result)(const Gas&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Sone 2007, sec. 3.1.5",
          .units = "length",
          .validity = "dilute gas of hard spheres, small gradients",
          .parameters = {diameter(), positive("number-density", "length^-3", "particles per volume")},
          .evaluate = [result](const Arguments& given) {
            Gas gas{.dimension = 3, .diameter = given.at("diameter")};
            gas.fraction = given.at("number-density") * particle_volume(gas);
            return result(gas);
          }};
}

std::vector<Law> flux_laws_of_gaps() {
  return {
      heat_law("free-molecular-heat-flux", "equal fluxes of two half-Maxwellians; docs/theory.md", kFree,
               with_fraction({low(), high(), mass(), diameter()}), free_molecular_heat_flux),
      stress_law("free-molecular-shear-stress", "equal fluxes of two half-Maxwellians; docs/theory.md", kFree,
                 with_fraction({low(), high(), sliding(), mass(), diameter()}), free_molecular_shear_stress),
      heat_law("continuum-heat-flux", "Fourier's law with the conductivity of the dilute gas", kDense,
               {low(), high(), width(), mass(), diameter(), dimension()}, continuum_heat_flux),
      stress_law("continuum-shear-stress", "Newton's law with the viscosity of the dilute gas", kDense,
                 {sliding(), width(), temperature(), mass(), diameter(), dimension()},
                 continuum_shear_stress)};
}

std::vector<Law> length_laws() {
  const std::string slip =
      "distance behind a diffuse wall where the bulk's straight velocity would be the wall's";
  const std::string jump =
      "distance behind a diffuse wall where the bulk's straight temperature would be the wall's";
  const std::string maxwell = "Maxwell 1879";
  const std::string estimate = "dilute gas, an estimate: up to 15% (slip), 18% (jump) too short";
  return {length_law("slip-length-maxwell", slip, maxwell, estimate, slip_length_maxwell),
          length_law("jump-length-maxwell", jump, maxwell, estimate, jump_length_maxwell),
          sphere_law("slip-length-spheres", slip, slip_length_of_spheres),
          sphere_law("jump-length-spheres", jump, jump_length_of_spheres)};
}
}  // namespace

std::vector<Law> diffuse_wall_laws() {
  std::vector<Law> laws{emission_law()};
  for (const auto& more : {flux_laws_of_gaps(), length_laws()})
    laws.insert(laws.end(), more.begin(), more.end());
  return laws;
}

}  // namespace sandglass::law
