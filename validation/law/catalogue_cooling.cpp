#include "validation/law/catalogue.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/shear_modes.hpp"
#include "validation/law/sonine.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kMaxwellian =
    "restitution below 1, fraction above 0, homogeneous, Maxwellian to zeroth order in a2";
constexpr const char* kSonine =
    "restitution below 1, fraction above 0, homogeneous, after a few collisions per particle; O(a2^2) left "
    "out";

/// A rate or time of the homogeneous gas.
Law gas_law(std::string name, std::string summary, std::string source, std::string units,
            std::string validity, double (*result)(const Gas&)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = std::move(units),
          .validity = std::move(validity),
          .parameters = with_fraction({dissipation(), temperature(), mass(), diameter()}),
          .evaluate = of_gas(result)};
}

Law shape_law(std::string name, std::string summary, std::string source, std::string validity,
              double (*shape)(int, double)) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = std::move(source),
          .units = "1",
          .validity = std::move(validity),
          .parameters = {dissipation(), dimension()},
          .evaluate = [shape](const Arguments& arguments) {
            const Gas gas = gas_from(arguments);
            return shape(gas.dimension, gas.restitution);
          }};
}

std::vector<Law> shape_laws() {
  const std::string first = "first Sonine coefficient of the homogeneous cooling state";
  const std::string third = "restitution from 0.3 on: the next order changes it by at most 0.0022 (1 - r^2)";
  return {
      shape_law("sonine-a2", first, "van Noije & Ernst 1998", "linear order in a2", sonine_a2),
      shape_law("sonine-a2-relinearised", first, "Montanero & Santos 2000; docs/theory.md",
                "linear order in a2; nearer to simulations for restitution below 0.6",
                sonine_a2_relinearised),
      shape_law("sonine-a2-third-order", first + ", a3 kept", "docs/theory.md", third,
                [](int dimension, double r) { return sonine_coefficients<3>(dimension, r)[0]; }),
      shape_law(
          "sonine-sixth-moment",
          "sixth moment of the speed over Maxwell's, less one, in the homogeneous cooling state: 3 a2 - a3",
          "docs/theory.md", third,
          [](int dimension, double r) { return sonine_sixth_moment(sonine_coefficients<3>(dimension, r)); })};
}

double collision_rate_sonine(const Gas& gas) {
  return collision_rate(gas) * sonine_collision_factor(sonine_a2(gas.dimension, gas.restitution));
}

std::vector<Law> rate_laws() {
  const std::string maxwell = "Haff 1983; Enskog rate, docs/theory.md";
  const std::string sonine = "van Noije & Ernst 1998; docs/theory.md";
  return {gas_law("cooling-rate", "relative loss of temperature per time, (1-r^2) omega/D", maxwell, "1/time",
                  kMaxwellian, cooling_rate),
          gas_law("cooling-rate-sonine", "cooling rate with the factor 1 + 3 a2/16", sonine, "1/time",
                  kSonine, cooling_rate_sonine),
          gas_law("collision-rate-sonine", "Enskog collision rate with the factor 1 - a2/16", sonine,
                  "1/time", kSonine, collision_rate_sonine),
          gas_law("haff-time-scale", "time scale of Haff's law, 2D/((1-r^2) omega)", maxwell, "time",
                  kMaxwellian, haff_time_scale),
          gas_law("haff-time-scale-sonine", "time scale of Haff's law with the Sonine cooling rate", sonine,
                  "time", kSonine, haff_time_scale_sonine),
          gas_law("marginal-wave-length",
                  "shear waves longer than this grow in a cooling gas, 2 pi sqrt(2 eta/(zeta rho))",
                  "Goldhirsch & Zanetti 1993; docs/theory.md", "length", kMaxwellian, marginal_wave_length)};
}

Law energy_law() {
  return {.name = "haff-energy-ratio",
          .summary = "energy over initial energy, (1 + t/t0)^-2",
          .source = "Haff 1983",
          .units = "1",
          .validity = "homogeneous, constant restitution",
          .parameters = {elapsed("time", "time", "time since the start"),
                         positive("time-scale", "time", "t0, see haff-time-scale")},
          .evaluate = [](const Arguments& arguments) {
            return haff_energy_ratio(arguments.at("time"), arguments.at("time-scale"));
          }};
}

Law collisions_law() {
  return {.name = "haff-collisions",
          .summary = "collisions per particle since the start, omega0 t0 ln(1 + t/t0)",
          .source = "Haff 1983, integrated; docs/theory.md",
          .units = "1",
          .validity = "homogeneous, constant restitution",
          .parameters = {positive("initial-rate", "1/time", "collisions per particle and time at the start"),
                         elapsed("time", "time", "time since the start"),
                         positive("time-scale", "time", "t0, see haff-time-scale")},
          .evaluate = [](const Arguments& arguments) {
            return haff_collisions(arguments.at("initial-rate"), arguments.at("time"),
                                   arguments.at("time-scale"));
          }};
}

Law energy_of_collisions_law() {
  return {.name = "haff-energy-ratio-of-collisions",
          .summary = "energy over initial energy after tau collisions per particle, exp(-(1-r^2) tau/D)",
          .source = "Müller 2001, sec. 3.1; docs/theory.md",
          .units = "1",
          .validity = "homogeneous, Maxwellian to zeroth order in a2",
          .parameters = {dissipation(), elapsed("collisions", "1", "collisions per particle"), dimension()},
          .evaluate = [](const Arguments& arguments) {
            const Gas gas = gas_from(arguments);
            return haff_energy_ratio_of_collisions(gas.dimension, gas.restitution,
                                                   arguments.at("collisions"));
          }};
}
}  // namespace

std::vector<Law> cooling_laws() {
  std::vector<Law> laws = rate_laws();
  for (auto law : {energy_law, collisions_law, energy_of_collisions_law}) laws.push_back(law());
  for (Law& law : shape_laws()) laws.push_back(std::move(law));
  return laws;
}

}  // namespace sandglass::law
