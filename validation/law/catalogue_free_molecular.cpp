#include "validation/law/catalogue.hpp"
#include "validation/law/free_molecular.hpp"
#include "validation/law/obstructed_column.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kEnergy = "mass length^2 time^-2";

Parameter share(std::string name, std::string summary) {
  return {.name = std::move(name),
          .units = "1",
          .summary = std::move(summary),
          .low = 0,
          .high = 1,
          .fallback = 0};
}

Law temperature_law() {
  return {.name = "knudsen-temperature",
          .summary = "temperature of a gas between two thermal walls that does not collide",
          .source = "equal fluxes of two half-Maxwellians; Kennard 1938, sec. 176",
          .units = kEnergy,
          .validity = "free flight, stationary, any dimension",
          .parameters = {positive("first-wall-temperature", kEnergy, "granular temperature of one wall"),
                         positive("second-wall-temperature", kEnergy, "granular temperature of the other")},
          .evaluate = [](const Arguments& arguments) {
            return knudsen_temperature(arguments.at("first-wall-temperature"),
                                       arguments.at("second-wall-temperature"));
          }};
}

StreamPastObstacle stream_from(const Arguments& arguments) {
  return {.dimension = static_cast<int>(arguments.at("dimension")),
          .number_density = arguments.at("number-density"),
          .mass = arguments.at("mass"),
          .temperature = arguments.at("temperature"),
          .velocity = arguments.at("stream-velocity"),
          .radius = arguments.at("radius"),
          .surface_temperature = arguments.at("surface-temperature"),
          .accommodation = arguments.at("accommodation"),
          .reversal = (1 - arguments.at("accommodation")) * arguments.at("reversal")};
}

Law drag_law() {
  return {
      .name = "free-molecular-drag",
      .summary = "force of a stream on a fixed disk or sphere much smaller than the mean free path",
      .source = "sphere: Baines et al. 1965; disk: Stalder et al. 1951; docs/theory.md",
      .units = "mass length time^-2",
      .validity = "free flight, drifting Maxwellian, particles much smaller than the obstacle, any speed",
      .parameters = {any_real("stream-velocity", "length/time", "mean velocity of the gas"),
                     with_fallback(positive("radius", "length", "of the obstacle"), 1),
                     positive("number-density", "length^-dimension", "particles per area or volume"),
                     temperature(), mass(),
                     with_fallback(positive("surface-temperature", kEnergy, "of a thermal surface"), 1),
                     share("accommodation", "share that leaves from a thermal surface"),
                     share("reversal", "share of the others that goes back the way it came"), dimension()},
      .evaluate = [](const Arguments& arguments) { return free_molecular_drag(stream_from(arguments)); }};
}

Law column_law() {
  return {
      .name = "barometric-fraction",
      .summary = "share of the particles of a column that lie below a height",
      .source = "Boltzmann factor exp(-m g z/T) between floor and lid",
      .units = "1",
      .validity = "ideal gas at rest at one temperature, with or without collisions",
      .parameters = {elapsed("height", "length", "above the floor"),
                     with_fallback(positive("lid", "length", "height of the lid"), 1),
                     elapsed("gravity", "length time^-2", "acceleration downwards"), temperature(), mass()},
      .evaluate = [](const Arguments& arguments) {
        return barometric_fraction(
            {arguments.at("mass"), arguments.at("temperature"), arguments.at("gravity"), arguments.at("lid")},
            arguments.at("height"));
      }};
}

Law floor_law() {
  return {
      .name = "column-floor-force",
      .summary = "mean force of one particle of a column on the floor, with a disk or sphere inside",
      .source = "pressure n T of the Boltzmann factor over the free part; docs/theory.md",
      .units = "mass length time^-2",
      .validity = "ideal gas at rest at one temperature, obstacle wholly inside, with or without collisions",
      .parameters = {with_fallback(positive("lid", "length", "height of the lid"), 1),
                     with_fallback(positive("area", "length^(dimension-1)", "of the floor"), 1),
                     elapsed("gravity", "length time^-2", "acceleration downwards"),
                     elapsed("centre-height", "length", "of the obstacle"),
                     elapsed("radius", "length", "of the obstacle; 0: none"), temperature(), mass(),
                     dimension()},
      .evaluate = [](const Arguments& arguments) {
        return floor_force({{arguments.at("mass"), arguments.at("temperature"), arguments.at("gravity"),
                             arguments.at("lid")},
                            static_cast<int>(arguments.at("dimension")),
                            arguments.at("area"),
                            {{arguments.at("centre-height"), arguments.at("radius")}}});
      }};
}
}  // namespace

std::vector<Law> free_molecular_laws() { return {temperature_law(), drag_law(), column_law(), floor_law()}; }

}  // namespace sandglass::law
