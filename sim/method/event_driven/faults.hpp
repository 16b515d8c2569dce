#pragma once

#include "sim/method/event_driven/wall_agent.hpp"

#include <algorithm>

namespace sandglass::event_driven {

/// Faults that the mutant suite plants in the engine.
struct Faults {
  double momentum_leak = 0;     ///< the second partner's kick is this part short
  bool stale_partner = false;   ///< a predicted contact is carried out whatever its partner did meanwhile
  bool blind_crossing = false;  ///< who enters a cell does not look ahead

  bool any() const { return momentum_leak != 0 || stale_partner || blind_crossing; }
};

/// Faults that it plants in walls and obstacles. Whoever makes the agents applies them.
struct AgentFaults {
  double restitution = 1;            ///< factor on the normal restitution, which stays at most 1
  double temperature = 1;            ///< factor on that of a thermal wall
  double obstacle_radius = 1;        ///< factor
  bool probability_ignored = false;  ///< every particle bounces back
  bool velocity_dropped = false;     ///< walls stand still, their vibration aside

  WallRule changed(WallRule rule) const {
    rule.surface.normal.value = std::min(1.0, restitution * rule.surface.normal.value);
    rule.temperature *= temperature;
    if (probability_ignored) rule.probability = 1;
    return rule;
  }
  template <int D>
  WallPlace<D> changed(WallPlace<D> place) const {
    if (velocity_dropped) place.velocity.setZero();
    return place;
  }
};

}  // namespace sandglass::event_driven
