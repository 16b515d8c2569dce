#pragma once

#include "sim/observe/plane.hpp"
#include "sim/physics/plane_flight.hpp"

#include <algorithm>
#include <cmath>

// Passages of planes by a path along an axis of period `length`, which a plane stands in once a period.

namespace sandglass::motion {

/// Between two places of an arc that does not turn back between them. The speed at a plane follows from the energy:
/// u^2 = v^2 + 2 a s.
inline void count_one_way(Plane& plane, double length, const Arc& arc, double from, double to) {
  const double first = std::floor((from - plane.position()) / length),
               last = std::floor((to - plane.position()) / length);
  const int passages = std::abs(static_cast<int>(last - first));
  for (int i = 0; i < passages; ++i) {
    const double image = plane.position() + length * (last > first ? first + 1 + i : first - i);
    const double square = arc.speed * arc.speed + 2 * arc.acceleration * (image - arc.place);
    plane.count(arc.acceleration == 0 ? arc.speed
                                      : std::copysign(std::sqrt(std::max(0.0, square)), last - first));
  }
}

/// All passages of an arc within the time t, at which it is at `end`: gravity may turn it back once.
inline void count_passages(Plane& plane, double length, const Arc& arc, double t, double end) {
  const double turn = arc.acceleration == 0 ? HUGE_VAL : -arc.speed / arc.acceleration;
  if (!(turn > 0 && turn < t)) return count_one_way(plane, length, arc, arc.place, end);
  const double summit = arc.at(turn);
  count_one_way(plane, length, arc, arc.place, summit);
  count_one_way(plane, length, arc, summit, end);
}

}  // namespace sandglass::motion
