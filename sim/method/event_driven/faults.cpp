#include "sim/method/event_driven/faults.hpp"

#include <algorithm>

namespace sandglass::event_driven {

WallRule AgentFaults::changed(WallRule rule) const {
  rule.surface.normal.value = std::min(1.0, restitution * rule.surface.normal.value);
  rule.temperature *= temperature;
  if (probability_ignored) rule.probability = 1;
  return rule;
}

}  // namespace sandglass::event_driven
