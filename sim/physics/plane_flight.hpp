#pragma once

#include "sim/physics/wall_motion.hpp"

namespace sandglass {

/// Motion along a line under constant acceleration: place + speed t + acceleration t^2 / 2.
struct Arc {
  double place, speed, acceleration;

  double at(double t) const { return place + t * (speed + 0.5 * acceleration * t); }
  double speed_at(double t) const { return speed + acceleration * t; }
  /// The same motion with time counted from t.
  Arc from(double t) const { return {at(t), speed_at(t), acceleration}; }
};

/// Earliest t >= 0 at which the arc is at or below zero on its way down; infinity if never. Below zero on the way up is no
/// event: rounding leaves a particle so after a bounce.
double time_to_fall(const Arc& arc);

/// Earliest t >= 0 at which a particle on the upper side hits a plane: `particle` is its coordinate along the plane's
/// normal, less its radius, and the plane's motion is counted from now (PlaneMotion::from). Touching and approaching
/// is now; no hit is missed, however fast or slow the plane vibrates.
double time_to_plane(const Arc& particle, const PlaneMotion& plane);

}  // namespace sandglass
