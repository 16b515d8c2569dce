#include "sim/method/event_driven/stall.hpp"

#include <fmt/format.h>

namespace sandglass::event_driven {

std::string collapse_message(double time, const std::string& first, const std::string& second, bool falling) {
  // On a floor the bounces of a restitution that goes to one as v^(3/4) still add up to a finite time.
  const char* remedy = falling ? "\"contact-time\"" : "\"contact-time\" or \"velocity-dependent\"";
  return fmt::format(
      "inelastic collapse at time {:.12g}: {} and {}: infinitely many collisions in a finite time; set "
      "method.collapse-guard to {}",
      time, first, second, remedy);
}

}  // namespace sandglass::event_driven
