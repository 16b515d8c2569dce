#include "sim/method/event_driven/stall.hpp"

#include <fmt/format.h>

namespace sandglass::event_driven {

std::string describe_particle(std::span<const double> position, const std::uint64_t* id) {
  const std::string place = fmt::format("({:.6g})", fmt::join(position, ", "));
  return id == nullptr ? "a particle at " + place : fmt::format("particle {} at {}", *id, place);
}

std::string collapse_message(double time, const std::string& first, const std::string& second, bool falling) {
  // On a floor the bounces of a restitution that goes to one as v^(3/4) still add up to a finite time.
  const char* remedy = falling ? "\"contact-time\"" : "\"contact-time\" or \"velocity-dependent\"";
  return fmt::format(
      "inelastic collapse at time {:.12g}: {} and {}: infinitely many collisions in a finite time; set "
      "method.collapse-guard to {}",
      time, first, second, remedy);
}

}  // namespace sandglass::event_driven
