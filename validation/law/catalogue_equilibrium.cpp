#include "validation/law/catalogue.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/state.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kFluid = "the fluid branch: area fraction below 0.70, volume fraction below 0.49";
constexpr const char* kPressureUnits = "mass length^(2-dimension) time^-2";

Law contact_law(std::string name, std::string summary, std::string source, std::string validity,
                double (*contact)(int, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = "1",
          .validity = std::move(validity),
          .parameters = with_fraction({}),
          .evaluate = [contact](const Arguments& arguments) {
            const Gas gas = gas_from(arguments);
            return contact(gas.dimension, gas.fraction);
          }};
}

Law pressure_law(std::string name, std::string summary, std::string validity, double (*result)(const Gas&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Chapman & Cowling 1970, ch. 16; (1+r)/2: Jenkins & Richman 1985",
          .units = kPressureUnits,
          .validity = std::move(validity),
          .parameters = with_fraction({restitution(), temperature(), diameter()}),
          .evaluate = of_gas(result)};
}

std::vector<Law> structure_laws() {
  return {contact_law("contact-value", "pair correlation of elastic hard particles at contact",
                      "Henderson 1975 (disks); Carnahan & Starling 1969 (spheres)", kFluid, contact_value),
          contact_law("contact-value-virial", "pair correlation at contact from ten virial coefficients",
                      "Clisby & McCoy 2006, table 1",
                      "area fraction below 0.30, volume fraction below 0.24 (1e-4 of the value left out)",
                      virial_contact_value)};
}

std::vector<Law> motion_laws() {
  return {{.name = "enskog-collision-rate",
           .summary = "collisions per particle and time of a Maxwellian gas",
           .source = "Chapman & Cowling 1970, ch. 16",
           .units = "1/time",
           .validity = kFluid,
           .parameters = with_fraction({temperature(), mass(), diameter()}),
           .evaluate = of_gas(collision_rate)},
          {.name = "mean-free-path",
           .summary = "mean speed over collision rate of a Maxwellian gas",
           .source = "Chapman & Cowling 1970, sec. 5.21 and ch. 16",
           .units = "length",
           .validity = std::string(kFluid) + ", fraction above 0",
           .parameters = with_fraction({diameter()}),
           .evaluate = of_gas(mean_free_path)},
          {.name = "mean-speed",
           .summary = "mean speed of a Maxwellian",
           .source = "Chapman & Cowling 1970, sec. 4.11",
           .units = "length/time",
           .validity = "any density",
           .parameters = {temperature(), mass(), dimension()},
           .evaluate = of_gas(mean_speed)}};
}

std::vector<Law> state_laws() {
  return {{.name = "compressibility-factor",
           .summary = "pressure over that of an ideal gas, Z = p/(nT)",
           .source = "Chapman & Cowling 1970, ch. 16; (1+r)/2: Jenkins & Richman 1985",
           .units = "1",
           .validity = kFluid,
           .parameters = with_fraction({restitution()}),
           .evaluate = of_gas(compressibility_factor)},
          pressure_law("pressure", "kinetic and collisional pressure together", kFluid, pressure),
          pressure_law("kinetic-pressure", "momentum carried by free flight, nT", "any density",
                       kinetic_pressure),
          pressure_law("collisional-pressure", "momentum handed across the diameter at contacts", kFluid,
                       collisional_pressure),
          {.name = "long-wave-structure",
           .summary = "structure factor at long wavelengths, S(0) = T (dn/dp)_T",
           .source = "Hansen & McDonald 2006, eq. 2.6.12",
           .units = "1",
           .validity = std::string(kFluid) + ", restitution 1",
           .parameters = with_fraction({}),
           .evaluate = of_gas(long_wave_structure)},
          {.name = "sound-speed",
           .summary = "adiabatic sound speed of the elastic gas",
           .source = "thermodynamics of the Enskog state, docs/theory.md",
           .units = "length/time",
           .validity = std::string(kFluid) + ", restitution 1, wavelength much above the mean free path",
           .parameters = with_fraction({temperature(), mass()}),
           .evaluate = of_gas(sound_speed)}};
}
}  // namespace

std::vector<Law> equilibrium_laws() {
  std::vector<Law> laws = structure_laws();
  for (const auto& more : {motion_laws(), state_laws()}) laws.insert(laws.end(), more.begin(), more.end());
  return laws;
}

}  // namespace sandglass::law
