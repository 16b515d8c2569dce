#include "validation/law/catalogue.hpp"
#include "validation/law/moments.hpp"
#include "validation/law/parameters.hpp"

namespace sandglass::law {

using namespace parameter;

namespace {
constexpr const char* kMomentUnits = "length^order time^-order";
constexpr const char* kSonineValidity =
    "even order; first Sonine order, the a3 term (from order 6 on) is left out; temperature is the actual "
    "one";

int order_of(const Arguments& arguments) { return static_cast<int>(arguments.at("order")); }

double component_moment(const Arguments& arguments) {
  const double speed = thermal_speed(gas_from(arguments));
  return maxwell_component_moment(order_of(arguments), speed * speed);
}

double speed_moment(const Arguments& arguments) {
  const Gas gas = gas_from(arguments);
  const double speed = thermal_speed(gas);
  return maxwell_speed_moment(gas.dimension, order_of(arguments), speed * speed);
}

Parameter even_order() {
  Parameter even = order();
  even.summary = "power of the velocity, even";
  even.step = 2;
  return even;
}

double factor(const Arguments& arguments) {
  return sonine_moment_factor(order_of(arguments), arguments.at("sonine-a2"));
}

std::vector<Law> maxwell_laws() {
  const std::string source = "Chapman & Cowling 1970, sec. 1.4";
  return {{.name = "maxwell-component-moment",
           .summary = "mean power of one velocity component of a Maxwellian",
           .source = source,
           .units = kMomentUnits,
           .validity = "equilibrium",
           .parameters = {order(), temperature(), mass()},
           .evaluate = component_moment},
          {.name = "maxwell-speed-moment",
           .summary = "mean power of the speed of a Maxwellian",
           .source = source,
           .units = kMomentUnits,
           .validity = "equilibrium",
           .parameters = {order(), temperature(), mass(), dimension()},
           .evaluate = speed_moment}};
}

std::vector<Law> sonine_laws() {
  const std::string source = "van Noije & Ernst 1998 (order 4); docs/theory.md (order 6 and 8)";
  return {{.name = "sonine-component-moment",
           .summary = "mean power of one velocity component of the first Sonine distribution",
           .source = source,
           .units = kMomentUnits,
           .validity = kSonineValidity,
           .parameters = {even_order(), sonine_a2(), temperature(), mass()},
           .evaluate = [](const Arguments& given) { return component_moment(given) * factor(given); }},
          {.name = "sonine-speed-moment",
           .summary = "mean power of the speed of the first Sonine distribution",
           .source = source,
           .units = kMomentUnits,
           .validity = kSonineValidity,
           .parameters = {even_order(), sonine_a2(), temperature(), mass(), dimension()},
           .evaluate = [](const Arguments& given) { return speed_moment(given) * factor(given); }}};
}
}  // namespace

std::vector<Law> velocity_laws() {
  std::vector<Law> laws = maxwell_laws();
  for (Law& law : sonine_laws()) laws.push_back(std::move(law));
  return laws;
}

}  // namespace sandglass::law
