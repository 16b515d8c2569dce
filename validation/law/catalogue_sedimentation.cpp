#include "validation/law/catalogue.hpp"
#include "validation/law/parameters.hpp"
#include "validation/law/sedimentation.hpp"
#include "validation/law/sinking_column.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kEnergy = "mass length^2 time^-2";
constexpr const char* kAppendix = "Kawasaki 1986, Appendix B";
constexpr const char* kIdeal = "ideal gas of many particles, closed column between floor and lid at rest";

Parameter lid() { return with_fallback(positive("lid", "length", "height of the lid"), 1); }
Parameter fall() { return positive("gravity", "length time^-2", "acceleration downwards"); }
Parameter freedom() {
  return {
      .name = "degrees-of-freedom",
      .units = "1",
      .summary =
          "of a particle, spins included: the dimension if smooth, 3 for rough disks, 6 for rough spheres",
      .low = 1,
      .high = 6};
}
Parameter second_mass() {
  return with_fallback(positive("second-mass", "mass", "particle mass of a second species"), 1);
}
Parameter second_share() {
  return {.name = "second-share",
          .units = "1",
          .summary = "share of all particles that are of the second species",
          .low = 0,
          .high = 1,
          .fallback = 0};
}

Column column_from(const Arguments& given) {
  return {given.at("mass"), given.at("temperature"), given.at("gravity"), given.at("lid")};
}

MixedColumn mixture_from(const Arguments& given) {
  const double share = given.at("second-share"), lid = given.at("lid");
  return {{{given.at("mass"), 1 - share, lid}, {given.at("second-mass"), share, lid}},
          given.at("gravity"),
          given.at("degrees-of-freedom")};
}

Law temperature_law() {
  return {.name = "sedimentation-temperature",
          .summary = "temperature at which a gas that started evenly spread comes to rest under gravity",
          .source = kAppendix,
          .units = kEnergy,
          .validity = kIdeal,
          .parameters = {with_fallback(positive("initial-temperature", kEnergy, "of the start"), 1), mass(),
                         second_mass(), second_share(), fall(), lid(), freedom()},
          .evaluate = [](const Arguments& given) {
            const MixedColumn column = mixture_from(given);
            return sedimentation_temperature(column,
                                             even_column_energy(column, given.at("initial-temperature")));
          }};
}

Law density_law() {
  return {
      .name = "sedimentation-density",
      .summary = "number density at a height over its mean, of each species by itself",
      .source = std::string(kAppendix) + ", (B.5)",
      .units = "1",
      .validity = kIdeal,
      .parameters = {elapsed("height", "length", "above the floor"), temperature(), mass(), fall(), lid()},
      .evaluate = [](const Arguments& given) {
        return column_density(column_from(given), given.at("height"));
      }};
}

Law height_law() {
  return {.name = "sedimentation-height",
          .summary = "mean height of the particles of a species",
          .source = std::string(kAppendix) + ", mean of (B.5)",
          .units = "length",
          .validity = kIdeal,
          .parameters = {temperature(), mass(), fall(), lid()},
          .evaluate = [](const Arguments& given) { return mean_column_height(column_from(given)); }};
}

Law sound_law() {
  return {.name = "column-sound-frequency",
          .summary = "angular frequency of the slowest sound wave in a column of one temperature",
          .source = "Lamb 1932, art. 309, between two rigid ends",
          .units = "time^-1",
          .validity = "inviscid, mean free path much shorter than the column; one species",
          .parameters = {temperature(), mass(), fall(), lid(), freedom()},
          .evaluate = [](const Arguments& given) {
            return column_sound_frequency(column_from(given), given.at("degrees-of-freedom"));
          }};
}

SinkingColumn sinking_from(const Arguments& given) {
  Gas gas{.dimension = static_cast<int>(given.at("dimension")),
          .diameter = given.at("diameter"),
          .mass = given.at("mass"),
          .temperature = given.at("initial-temperature")};
  gas.fraction = given.at("number-density") * particle_volume(gas);
  return {gas, given.at("gravity"), given.at("lid"), given.at("degrees-of-freedom")};
}

Law bounce_law(std::string name, std::string summary, std::string units, double Bounce::*part) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .source = "equations of Navier, Stokes and Fourier, solved; docs/theory.md",
          .units = std::move(units),
          .validity =
              "dilute gas, evenly spread at rest at the start; to second order in the mean free path over "
              "the height",
          .parameters = {with_fallback(positive("initial-temperature", kEnergy, "of the start"), 1), mass(),
                         diameter(), positive("number-density", "length^-dimension", "mean over the column"),
                         fall(), lid(), freedom(), dimension()},
          .evaluate = [part](const Arguments& given) { return first_bounce(sinking_from(given)).*part; }};
}
}  // namespace

std::vector<Law> sedimentation_laws() {
  return {temperature_law(),
          density_law(),
          height_law(),
          sound_law(),
          bounce_law("sedimentation-swing-time", "time at which the centre of mass is lowest", "time",
                     &Bounce::time),
          bounce_law("sedimentation-overshoot",
                     "how far the centre of mass sinks below its place at rest, over its fall to there", "1",
                     &Bounce::depth)};
}

}  // namespace sandglass::law
