#pragma once

#include "sim/motion/parameters.hpp"
#include "sim/physics/wall_motion.hpp"
#include "sim/space/ball_index.hpp"

#include <cmath>

namespace sandglass::motion {

/// A wall as the flight needs it: along its inward normal.
template <int D>
struct WallSurface {
  explicit WallSurface(const WallPlace<D>& place);

  /// Of a point above the plane; negative behind it.
  double height(const Vector<D>& x, double time) const { return inward * x[place.axis] - along(time); }
  Vector<D> normal() const { return inward * Vector<D>::Unit(place.axis); }
  Vector<D> velocity_at(double time) const {
    Vector<D> velocity = place.velocity;
    velocity[place.axis] = inward * motion.velocity_at(time);
    return velocity;
  }
  /// Coordinate along the axis of the plane.
  double at(double time) const { return inward * along(time); }
  /// The motion with time counted from `time` and place from where the plane stands then.
  PlaneMotion from_now(double time) const {
    PlaneMotion now = motion.from(time);
    now.position = -now.amplitude * std::sin(now.phase);
    return now;
  }
  /// A coordinate that the plane does not pass from its outer side during a step: all that lies farther in is free.
  double reach(double time, double dt) const;

  WallPlace<D> place;
  double inward;       ///< +1 at a low side, -1 at a high one
  PlaneMotion motion;  ///< along the inward normal

 private:
  double along(double time) const { return place.moves() ? motion.at(time) : motion.position; }
};

/// A side of the box that lets particles out.
struct OpenSide {
  int axis;
  double edge;
  double inward;  ///< +1 at a low side, -1 at a high one

  /// Of a coordinate; negative outside.
  double height(double x) const { return inward * (x - edge); }
};

/// Walls, open sides and obstacles of every kind, ready for the flight between them.
template <int D>
struct Surfaces {
  Surfaces(const MotionParameters<D>& parameters, const Vector<D>& box);

  /// The side by which a particle there has left the box; null: by none.
  const OpenSide* left_by(const Vector<D>& x) const {
    for (const OpenSide& side : open)
      if (side.height(x[side.axis]) < 0) return &side;
    return nullptr;
  }
  bool has_left(const Vector<D>& x) const { return left_by(x) != nullptr; }

  MotionParameters<D> parameters;
  std::vector<WallSurface<D>> walls;  ///< the sides of each walled axis that are not open, low side first
  std::vector<OpenSide> open;
  BallIndex<D> obstacles;  ///< a little larger than they are: who touches one by rounding is found
  bool draws = false;      ///< some rule asks for random numbers

 private:
  void add_side(const Vector<D>& box, int axis, bool high);
};

/// Whether all walls are smooth, elastic, at rest and at the edges of the box, and there is no obstacle. Asked of a box
/// without open sides.
template <int D>
bool are_plain(const MotionParameters<D>& parameters, const Vector<D>& box);

}  // namespace sandglass::motion
