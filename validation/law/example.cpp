#include "validation/law/example.hpp"

namespace sandglass::law {

Arguments example_arguments(const Law& law, int dimension) {
  Arguments arguments;
  for (const Parameter& parameter : law.parameters) {
    if (parameter.dimension != 0 && parameter.dimension != dimension) continue;
    const bool bounded = parameter.high <= 8;
    arguments[parameter.name] = bounded              ? (parameter.low + parameter.high) / 2
                                : parameter.step > 0 ? parameter.low + parameter.step
                                                     : 0.5;
    if (parameter.name == "dimension") arguments[parameter.name] = dimension;
  }
  return arguments;
}

}  // namespace sandglass::law
