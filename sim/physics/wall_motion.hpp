#pragma once

#include "sim/base/vector.hpp"

#include <cmath>

namespace sandglass {

/// A plane that moves along its normal: position + speed t + A sin(2 pi f t + phase).
struct PlaneMotion {
  double position = 0, speed = 0;
  double amplitude = 0;
  double frequency = 0;  ///< cycles per time
  double phase = 0;      ///< radians

  bool vibrates() const { return amplitude != 0 && frequency != 0; }
  double angular_frequency() const { return 2 * M_PI * frequency; }
  /// In [-pi, pi]. Whole cycles are taken off first: they would cost digits.
  double angle(double t) const {
    const double cycles = frequency * t;
    return std::remainder(2 * M_PI * (cycles - std::nearbyint(cycles)) + phase, 2 * M_PI);
  }
  double at(double t) const { return position + speed * t + amplitude * std::sin(angle(t)); }
  double velocity_at(double t) const { return speed + amplitude * angular_frequency() * std::cos(angle(t)); }
  double acceleration_at(double t) const {
    return -amplitude * angular_frequency() * angular_frequency() * std::sin(angle(t));
  }
  /// The same motion with time counted from t.
  PlaneMotion from(double t) const { return {position + speed * t, speed, amplitude, frequency, angle(t)}; }
};

/// How a wall moves: at constant velocity (along itself too) and by a vibration along its normal.
template <int D>
struct WallMotion {
  Vector<D> velocity = Vector<D>::Zero();
  double amplitude = 0, frequency = 0, phase = 0;  ///< as in PlaneMotion

  /// Along the unit vector `normal`, for the plane normal . x = position at time zero without its vibration.
  PlaneMotion along(const Vector<D>& normal, double position) const {
    return {position, velocity.dot(normal), amplitude, frequency, phase};
  }
  Vector<D> velocity_at(const Vector<D>& normal, double t) const {
    const double steady = velocity.dot(normal);
    return velocity + (along(normal, 0).velocity_at(t) - steady) * normal;
  }
};

}  // namespace sandglass
