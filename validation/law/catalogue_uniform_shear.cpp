#include "validation/law/catalogue.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/uniform_shear.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kEnergy = "mass length^2 time^-2";
constexpr const char* kPressure = "mass length^(2-dimension) time^-2";
constexpr const char* kGrad = "Grad's method, linear in the stress; Brey, Ruiz-Montero & Moreno 1997";
constexpr const char* kLun =
    "Lun, Savage, Jeffrey & Chepurniy 1984 (spheres); the same derivation, Jenkins & Richman 1985 as r -> 1 "
    "(disks)";
constexpr const char* kDilute =
    "dilute, steady, homogeneous, restitution 0.8 or more: stress within 2.5%, temperature 2.2% too low (r "
    "-> 1) to 7% "
    "too high (r = 0.8)";
constexpr const char* kDense =
    "steady, homogeneous, restitution 0.9 or more, area fraction below 0.6, volume fraction below 0.45; "
    "first order in "
    "the rate: temperature too high, by 4% (0.95) to 12% (0.9); stress within 2% above a fraction of 0.4, up "
    "to 14% too "
    "high when dilute (0.9)";

using OfShear = double (*)(const Gas&, double);

std::function<double(const Arguments&)> at_rate(OfShear result) {
  return [result](const Arguments& given) { return result(gas_from(given), given.at("shear-rate")); };
}

Law dilute_law(std::string name, std::string summary, std::function<double(int, double)> result) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = kGrad,
          .units = "1",
          .validity = kDilute,
          .parameters = {dissipation(), dimension()},
          .evaluate = [result = std::move(result)](const Arguments& given) {
            return result(static_cast<int>(given.at("dimension")), given.at("restitution"));
          }};
}

Law stress_law(const std::string& component, std::function<double(const ReducedStress&)> part) {
  return dilute_law(
      "uniform-shear-" + component + "-dilute", component + " of the sheared dilute gas over nT",
      [part = std::move(part)](int dimension, double r) { return part(dilute_shear_stress(dimension, r)); });
}

Law law_of_shear(std::string name, std::string summary, std::string units, OfShear result, bool dilute) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = dilute ? kGrad : kLun,
          .units = std::move(units),
          .validity = dilute ? kDilute : kDense,
          .parameters = with_fraction({shear_rate(), dissipation(), mass(), diameter()}),
          .evaluate = at_rate(result)};
}

Law viscosity_law() {
  return {.name = "inelastic-shear-viscosity",
          .summary = "shear viscosity of the dense inelastic gas",
          .source = kLun,
          .units = "mass length^(2-dimension) time^-1",
          .validity = kDense,
          .parameters = with_fraction({temperature(), mass(), diameter(), dissipation()}),
          .evaluate = of_gas(inelastic_shear_viscosity)};
}
}  // namespace

std::vector<Law> uniform_shear_laws() {
  return {dilute_law("uniform-shear-rate-dilute", "shear rate over nT/eta0 that the dilute gas settles at",
                     dilute_shear_rate),
          stress_law("xx-stress", [](const ReducedStress& stress) { return stress.xx; }),
          stress_law("yy-stress", [](const ReducedStress& stress) { return stress.yy; }),
          stress_law("xy-stress", [](const ReducedStress& stress) { return stress.xy; }),
          stress_law("friction", [](const ReducedStress& stress) { return stress.xy / stress.yy; }),
          law_of_shear("uniform-shear-temperature-dilute", "granular temperature of the sheared dilute gas",
                       kEnergy, dilute_shear_temperature, true),
          viscosity_law(),
          law_of_shear("uniform-shear-temperature", "granular temperature of the sheared dense gas", kEnergy,
                       shear_temperature, false),
          law_of_shear("uniform-shear-stress", "shear stress of the sheared dense gas", kPressure,
                       shear_stress, false),
          law_of_shear("uniform-shear-pressure", "pressure of the sheared dense gas", kPressure,
                       shear_pressure, false)};
}

}  // namespace sandglass::law
