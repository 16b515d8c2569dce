#pragma once

#include "sim/base/vector.hpp"

#include <cstdint>

namespace sandglass {

/// One event of an event-driven run, for those who trace it.
template <int D>
struct Event {
  enum class Kind { collision, agent } kind = Kind::collision;
  double time = 0;
  std::uint64_t first = 0, second = 0;  ///< identities of the particles; of the agent for an agent's event
  Vector<D> position;                   ///< of the first particle
  Vector<D> normal;                     ///< from the second to the first; zero for an agent's event
  Vector<D> velocity_1, velocity_2;     ///< after the event
  double approach = 0;                  ///< speed along the normal before a collision
};

/// Takes every event, in the order of time.
template <int D>
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void record(const Event<D>& event) = 0;
};

}  // namespace sandglass
