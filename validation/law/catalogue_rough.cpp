#include "validation/law/catalogue.hpp"
#include "validation/law/mixture.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/rough.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kRough =
    "homogeneous, Maxwellian velocities and normal spins that do not depend on each other; no sliding";
constexpr const char* kMixture = "homogeneous, each species Maxwellian; molecular chaos";

Parameter tangential() {
  return {.name = "tangential-restitution",
          .units = "1",
          .summary = "-1 smooth, 1 perfectly rough; KAW's eps_s with the other sign",
          .low = -1,
          .high = 1};
}

Parameter inertia() {
  return {.name = "moment-of-inertia",
          .units = "1",
          .summary = "q of I = q m R^2",
          .low = 1e-6,
          .high = 1,
          .fallback = 0.4};
}

RoughGas rough_from(const Arguments& arguments) {
  return {static_cast<int>(arguments.at("dimension")), arguments.at("restitution"),
          arguments.at("tangential-restitution"), arguments.at("moment-of-inertia")};
}

Law cooling_law(std::string name, std::string summary, Parameter elapsed,
                Temperatures (*cooling)(const RoughGas&, const Temperatures&, double),
                double Temperatures::*which) {
  const std::string key = elapsed.name;
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Huthmann & Zippelius 1997; Luding et al. 1998; docs/theory.md",
          .units = "1",
          .validity = kRough,
          .parameters = {restitution(), tangential(), inertia(),
                         with_fallback(parameter::elapsed("initial-ratio", "1", "T_r/T_t at the start"), 1),
                         std::move(elapsed), dimension()},
          .evaluate = [=](const Arguments& given) {
            return cooling(rough_from(given), {1, given.at("initial-ratio")}, given.at(key)).*which;
          }};
}

Law ratio_law() {
  return {.name = "rough-temperature-ratio",
          .summary = "T_r/T_t after many collisions",
          .source = "Huthmann & Zippelius 1997; docs/theory.md",
          .units = "1",
          .validity = std::string(kRough) + "; tangential restitution above -1",
          .parameters = {restitution(), tangential(), inertia(), dimension()},
          .evaluate = [](const Arguments& given) { return rough_temperature_ratio(rough_from(given)); }};
}

Component numbered(const Arguments& given, const std::string& number) {
  return {given.at("number-density-" + number), given.at("diameter-" + number), given.at("mass-" + number),
          given.at("temperature-" + number)};
}

std::vector<Parameter> two_species() {
  std::vector<Parameter> all;
  for (const std::string number : {"1", "2"}) {
    all.push_back(positive("number-density-" + number, "length^-D", "of species " + number));
    all.push_back(with_fallback(positive("diameter-" + number, "length", "of species " + number), 1));
    all.push_back(with_fallback(positive("mass-" + number, "mass", "of species " + number), 1));
    all.push_back(with_fallback(
        positive("temperature-" + number, "mass length^2 time^-2", "granular, of species " + number), 1));
  }
  all.push_back(dimension());
  return all;
}

Law rate_law() {
  std::vector<Parameter> parameters = two_species();
  parameters.push_back(with_fallback(positive("contact-value", "1", "g of the pair"), 1));
  return {.name = "mixture-collision-rate",
          .summary = "collisions of a particle of species 1 with those of species 2 per time",
          .source = "Chapman & Cowling 1970, ch. 5; docs/theory.md",
          .units = "1/time",
          .validity = kMixture,
          .parameters = std::move(parameters),
          .evaluate = [](const Arguments& given) {
            return mixture_collision_rate(static_cast<int>(given.at("dimension")), numbered(given, "1"),
                                          numbered(given, "2"), given.at("contact-value"));
          }};
}

Law contact_law(std::string name, std::string summary, std::size_t i, std::size_t j) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "Jenkins & Mancini 1987 (2D); Boublik 1970, Mansoori et al. 1971 (3D)",
          .units = "1",
          .validity =
              "elastic fluid mixture; 1% up to area fraction 0.5 and volume fraction 0.4 of similar sizes",
          .parameters = two_species(),
          .evaluate = [i, j](const Arguments& given) {
            return mixture_contact_value(static_cast<int>(given.at("dimension")),
                                         {numbered(given, "1"), numbered(given, "2")}, i, j);
          }};
}

Law mixture_ratio_law() {
  std::vector<Parameter> parameters = two_species();
  parameters.push_back(dissipation());
  return {.name = "mixture-temperature-ratio",
          .summary = "T_1/T_2 of a cooling dilute mixture once both species cool alike",
          .source = "Garzo & Dufty 1999; docs/theory.md",
          .units = "1",
          .validity = std::string(kMixture) + "; one restitution for all pairs, contact values 1",
          .parameters = std::move(parameters),
          .evaluate = [](const Arguments& given) {
            return mixture_temperature_ratio(static_cast<int>(given.at("dimension")), given.at("restitution"),
                                             numbered(given, "1"), numbered(given, "2"));
          }};
}
}  // namespace

std::vector<Law> rough_laws() {
  const Parameter tau = elapsed("collisions", "1", "collisions per particle");
  const Parameter time = elapsed("mean-free-times", "1", "time in mean free times of the start");
  return {cooling_law("rough-translation", "translational temperature over that of the start", tau,
                      rough_cooling, &Temperatures::translation),
          cooling_law("rough-rotation", "rotational temperature over the translational one of the start", tau,
                      rough_cooling, &Temperatures::rotation),
          cooling_law("rough-translation-in-time", "the same in time: translation", time,
                      rough_cooling_in_time, &Temperatures::translation),
          cooling_law("rough-rotation-in-time", "the same in time: rotation", time, rough_cooling_in_time,
                      &Temperatures::rotation),
          ratio_law()};
}

std::vector<Law> mixture_laws() {
  return {
      rate_law(),
      contact_law("mixture-contact-value", "pair correlation at contact of species 1 with species 2", 0, 1),
      contact_law("mixture-contact-value-alike", "pair correlation at contact within species 1", 0, 0),
      {.name = "mixture-compressibility",
       .summary = "p/(n T) of an elastic mixture of two species",
       .source = "virial theorem with the contact values; docs/theory.md",
       .units = "1",
       .validity = "elastic fluid mixture, one temperature; as the contact values",
       .parameters = two_species(),
       .evaluate =
           [](const Arguments& given) {
             return mixture_compressibility(static_cast<int>(given.at("dimension")),
                                            {numbered(given, "1"), numbered(given, "2")});
           }},
      mixture_ratio_law()};
}

}  // namespace sandglass::law
