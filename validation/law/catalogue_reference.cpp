#include "validation/law/catalogue.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/virial.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kVirialSource = "Baus & Colot 1987, with Clisby & McCoy 2006, table 1";
constexpr const char* kReferenceSource =
    "Baus & Colot 1987, Clisby & McCoy 2006; Luding 2001 for disks above 0.60";
constexpr const char* kReferenceValidity =
    "elastic fluid; area fraction to 0.66 (error below 0.1% to 0.60, 0.2% above), volume fraction to 0.49 "
    "(0.3%)";

double total_error(const Bounded& result) { return std::hypot(result.standard_error, result.bound); }

Law reference_law(std::string name, std::string summary, std::string units, std::vector<Parameter> parameters,
                  double (*result)(const Gas&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = kReferenceSource,
          .units = std::move(units),
          .validity = kReferenceValidity,
          .parameters = with_fraction(std::move(parameters)),
          .evaluate = of_gas(result)};
}

Law virial_law(std::string name, std::string summary, double (*result)(const Gas&)) {
  Law law = reference_law(std::move(name), std::move(summary), "1", {}, result);
  law.source = kVirialSource;
  law.validity = "elastic fluid, area fraction below 0.60, volume fraction below 0.49";
  return law;
}
}  // namespace

std::vector<Law> reference_laws() {
  return {
      virial_law("virial-compressibility", "Z of the elastic fluid from ten virial coefficients, rescaled",
                 [](const Gas& gas) { return virial_compressibility(gas.dimension, gas.fraction).value; }),
      virial_law(
          "virial-compressibility-error", "error of virial-compressibility: coefficients and last term",
          [](const Gas& gas) { return total_error(virial_compressibility(gas.dimension, gas.fraction)); }),
      reference_law(
          "contact-value-reference", "contact value of the elastic fluid, as well as it is known", "1", {},
          [](const Gas& gas) { return reference_contact_value(gas.dimension, gas.fraction).value; }),
      reference_law(
          "contact-value-reference-error", "error of contact-value-reference", "1", {},
          [](const Gas& gas) { return total_error(reference_contact_value(gas.dimension, gas.fraction)); }),
      reference_law("compressibility-reference", "Z with the reference contact value", "1", {restitution()},
                    [](const Gas& gas) { return reference_compressibility(gas).value; }),
      reference_law("collision-rate-reference",
                    "collisions per particle and time with the reference contact value", "1/time",
                    {temperature(), mass(), diameter()},
                    [](const Gas& gas) { return reference_collision_rate(gas).value; })};
}

}  // namespace sandglass::law
