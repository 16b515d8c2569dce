#include "validation/law/parameters.hpp"

#include <limits>

namespace sandglass::law::parameter {

namespace {
constexpr double kTiny = std::numeric_limits<double>::min();
constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kClosePackedDisks = 0.90689968211710892;    // pi/(2 sqrt 3)
constexpr double kClosePackedSpheres = 0.74048048969306104;  // pi/(3 sqrt 2)

double value_or(const Arguments& arguments, const std::string& name, double fallback) {
  const auto found = arguments.find(name);
  return found == arguments.end() ? fallback : found->second;
}
}  // namespace

Parameter dimension() {
  return {.name = "dimension",
          .units = "1",
          .summary = "2 for disks, 3 for spheres",
          .low = 2,
          .high = 3,
          .step = 1};
}

Parameter diameter() { return with_fallback(positive("diameter", "length", "particle diameter"), 1); }

Parameter mass() { return with_fallback(positive("mass", "mass", "particle mass"), 1); }

Parameter temperature() {
  return with_fallback(
      positive("temperature", "mass length^2 time^-2", "granular temperature m<C^2>/dimension"), 1);
}

Parameter area_fraction() {
  return {.name = "area-fraction",
          .units = "1",
          .summary = "area covered by disks, up to close packing",
          .low = 0,
          .high = kClosePackedDisks,
          .dimension = 2};
}

Parameter volume_fraction() {
  return {.name = "volume-fraction",
          .units = "1",
          .summary = "volume filled by spheres, up to close packing",
          .low = 0,
          .high = kClosePackedSpheres,
          .dimension = 3};
}

Parameter restitution() { return with_fallback(dissipation(), 1); }

Parameter dissipation() {
  return {.name = "restitution", .units = "1", .summary = "normal restitution", .low = 0, .high = 1};
}

Parameter positive(std::string name, std::string units, std::string summary) {
  return {std::move(name), std::move(units), std::move(summary), kTiny, kHuge};
}

Parameter any_real(std::string name, std::string units, std::string summary) {
  return {std::move(name), std::move(units), std::move(summary), -kHuge, kHuge};
}

Parameter elapsed(std::string name, std::string units, std::string summary) {
  return {std::move(name), std::move(units), std::move(summary), 0, kHuge};
}

Parameter gravity() {
  return with_fallback(positive("gravity", "length time^-2", "acceleration downwards"), 1);
}

Parameter further_restitution(std::string name, std::string summary) {
  return {std::move(name), "1", std::move(summary), 0, 1, 1};
}

Parameter shear_rate() { return positive("shear-rate", "1/time", "of the mean velocity across the flow"); }

Parameter with_fallback(Parameter parameter, double fallback) {
  parameter.fallback = fallback;
  return parameter;
}

Parameter order() {
  return {.name = "order", .units = "1", .summary = "power of the velocity", .low = 0, .high = 8, .step = 1};
}

Parameter sonine_a2() {
  return {.name = "sonine-a2",
          .units = "1",
          .summary = "first Sonine coefficient of the velocity distribution",
          .low = -0.5,
          .high = 0.5};
}

std::vector<Parameter> with_fraction(std::vector<Parameter> parameters) {
  parameters.push_back(area_fraction());
  parameters.push_back(volume_fraction());
  parameters.push_back(dimension());
  return parameters;
}

Gas gas_from(const Arguments& arguments) {
  Gas gas;
  gas.dimension = static_cast<int>(value_or(arguments, "dimension", gas.dimension));
  gas.diameter = value_or(arguments, "diameter", gas.diameter);
  gas.mass = value_or(arguments, "mass", gas.mass);
  gas.temperature = value_or(arguments, "temperature", gas.temperature);
  gas.fraction = value_or(arguments, gas.dimension == 2 ? "area-fraction" : "volume-fraction", gas.fraction);
  gas.restitution = value_or(arguments, "restitution", gas.restitution);
  return gas;
}

std::function<double(const Arguments&)> of_gas(double (*result)(const Gas&)) {
  return [result](const Arguments& arguments) { return result(gas_from(arguments)); };
}

}  // namespace sandglass::law::parameter
