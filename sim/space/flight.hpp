#pragma once

#include <algorithm>
#include <cmath>

namespace sandglass {

/// Coordinate in [0, length) of a point of the line with period `length`.
inline double wrap(double x, double length, double per_length) {
  x -= length * std::floor(x * per_length);
  return x < length ? x : 0.0;  // -1e-20 + length rounds to length
}

/// Coordinate in [0, length] of a point mirrored at both ends as often as needed.
inline double mirror(double x, double length) {
  x = std::fabs(x);
  x -= 2 * length * std::floor(x / (2 * length));
  return std::min(x, 2 * length - x);
}

/// Flight between specular walls at 0 and `length` without a force.
inline void fly_between_walls(double& x, double& velocity, double dt, double length) {
  x += velocity * dt;
  if (x >= 0 && x <= length) return;
  const double bounces = std::floor(x / length);
  if (std::fmod(bounces, 2.0) != 0) velocity = -velocity;
  x = mirror(x, length);
}

/// First time in (0, inf) at which x + v t + a t^2 / 2 reaches `wall` while moving towards it from inside; infinity if
/// never. `x` is on the inner side or on the wall; `outward` is -1 for the wall at 0, +1 for the far one.
inline double time_to_wall(double x, double v, double a, double wall, double outward) {
  const double gap = std::max(0.0, (wall - x) * outward), speed = v * outward, pull = a * outward;
  // pull t^2 / 2 + speed t = gap, smallest root reached from inside, in the form that does not cancel.
  const double discriminant = speed * speed + 2 * pull * gap;
  if (discriminant < 0) return HUGE_VAL;
  const double root = std::sqrt(discriminant);
  if (speed > 0) return 2 * gap / (speed + root);
  return pull > 0 ? (root - speed) / pull : HUGE_VAL;
}

/// Exact flight under constant acceleration between specular walls at 0 and `length`.
inline void fall_between_walls(double& x, double& velocity, double acceleration, double dt, double length) {
  for (int bounces = 0; bounces < 1000; ++bounces) {
    const double low = time_to_wall(x, velocity, acceleration, 0, -1);
    const double high = time_to_wall(x, velocity, acceleration, length, 1);
    const double hit = std::min(low, high);
    if (hit >= dt) break;
    velocity = -(velocity + acceleration * hit);
    x = low < high ? 0 : length;
    dt -= hit;
    // At rest on the wall that it is pressed to: bounces without height take no time.
    if (hit == 0 && std::fabs(velocity) * 2 <= std::fabs(acceleration) * dt * 1e-12) {
      velocity = 0;
      return;
    }
  }
  x = std::clamp(x + dt * (velocity + 0.5 * acceleration * dt), 0.0, length);
  velocity += acceleration * dt;
}

}  // namespace sandglass
