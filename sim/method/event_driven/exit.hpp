#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/flight.hpp"

namespace sandglass::event_driven {

/// Where and when a particle leaves its cell.
struct Exit {
  double time = HUGE_VAL;
  int axis = 0;
  bool up = false;

  /// As Next keeps it. It is not looked for again at the crossing: there, an arc that hardly gets over the edge may seem
  /// to turn before it.
  std::uint32_t code() const { return 2 * static_cast<std::uint32_t>(axis) + up; }
  static int axis_of(std::uint32_t code) { return static_cast<int>(code / 2); }
  static bool up_of(std::uint32_t code) { return code % 2 != 0; }
};

/// When an arc leaves through one face of its cell. One that is back before the clock moves on does not: it would leave
/// and come back without an end.
inline double time_to_exit(double x, double v, double g, double face, double outward, double now) {
  const double time = time_to_wall(x, v, g, face, outward);
  const double pull = g * outward, gap = std::max(0.0, (face - x) * outward);
  if (!(time < HUGE_VAL) || pull >= 0) return time;
  const double outside = -2 * std::sqrt(std::max(0.0, v * v + 2 * pull * gap)) / pull;
  return now + time + outside > now + time ? time : HUGE_VAL;
}

/// First exit after `now`. A straight flight is followed from its beginning, so that every look gives the same time; a
/// parabola may come back through the wall where it came in, and is followed from now.
template <int D, class Flight>
Exit first_exit(const Cells<D>& cells, const Flight& flight, const Particle<D>& particle, std::uint32_t cell,
                double now) {
  Exit exit;
  if constexpr (Flight::falls) {
    const Vector<D> position = flight.position(particle, now), velocity = flight.velocity(particle, now);
    for (int axis = 0; axis < D; ++axis) {
      const double x = position[axis], v = velocity[axis], g = flight.acceleration(axis);
      const double down = time_to_exit(x, v, g, cells.edge(cell, axis, false), -1, now);
      const double up = time_to_exit(x, v, g, cells.edge(cell, axis, true), 1, now);
      if (now + std::min(down, up) < exit.time) exit = {now + std::min(down, up), axis, up < down};
    }
  } else {
    for (int axis = 0; axis < D; ++axis) {
      const double v = particle.velocity[axis];
      const bool up = v > 0;
      const double edge = cells.edge(cell, axis, up);
      const double time = v != 0 ? particle.time + (edge - particle.position[axis]) / v : HUGE_VAL;
      const bool sooner = time < exit.time;
      exit.time = sooner ? time : exit.time;
      exit.axis = sooner ? axis : exit.axis;
      exit.up = sooner ? up : exit.up;
    }
    exit.time = std::max(exit.time, now);
  }
  return exit;
}

}  // namespace sandglass::event_driven
