#pragma once

#include "sim/base/vector.hpp"

#include <cstdint>

namespace sandglass::event_driven {

inline constexpr std::uint32_t kNobody = ~std::uint32_t{0};

/// A particle on its way, at the time of its last change: what everybody near it has to read. One cache line.
template <int D>
struct alignas(64) Body {
  Vector<D> position, velocity;
  double time;
  std::uint32_t changes;  ///< of its flight; predictions made before the last one are out of date
  std::uint32_t below;    ///< the next particle in the same cell, or nobody
};

/// What will happen to a particle next: a contact or, before that, the crossing of a cell wall.
struct Next {
  double time;                    ///< of whichever comes first
  double contact;                 ///< time of the contact
  std::uint32_t partner;          ///< a particle, an agent (kFirstAgent + index), or nobody
  std::uint32_t partner_changes;  ///< changes of the partner when the contact was predicted
  std::uint32_t cell;             ///< where the particle is
  std::uint32_t exit;             ///< by which it leaves that cell: twice the axis, one more for upwards
};

/// Partner numbers from here on mean agents.
inline constexpr std::uint32_t kFirstAgent = 0xffffff00u;

}  // namespace sandglass::event_driven
