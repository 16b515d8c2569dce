#pragma once

#include <algorithm>
#include <cmath>

namespace sandglass {

/// Coordinate in [0, length) of a point of the line with period `length`.
inline double wrap(double x, double length, double per_length) {
  x -= length * std::floor(x * per_length);
  return x >= 0 && x < length ? x : 0.0;  // rounding: -1e-20 + length is length
}

/// Coordinate in [0, length] of a point mirrored at both ends as often as needed.
inline double mirror(double x, double length) {
  x = std::fabs(x);
  x -= 2 * length * std::floor(x / (2 * length));
  return std::max(0.0, std::min(x, 2 * length - x));  // rounding, many lengths away
}

/// Sums of the speeds at which a particle hits the wall at 0 and the far one.
struct HitSpeeds {
  double low = 0, high = 0;

  void add(bool far, double speeds) { (far ? high : low) += speeds; }
};

/// Flight between specular walls at 0 and `length` without a force. `hits`: counts them; null for no one.
inline void fly_between_walls(double& x, double& velocity, double dt, double length,
                              HitSpeeds* hits = nullptr) {
  x += velocity * dt;
  if (x >= 0 && x <= length) return;
  const double bounces = std::floor(x / length);
  if (hits != nullptr) {  // by turns
    const double speed = std::fabs(velocity), second = std::floor(std::fabs(bounces) / 2);
    hits->add(velocity > 0, (std::fabs(bounces) - second) * speed);
    hits->add(velocity <= 0, second * speed);
  }
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

/// Exact flight under constant acceleration between specular walls at 0 and `length`. From the first wall on the motion is
/// periodic: any number of bounces costs as much as two. `hits`: counts them, and takes what presses on a wall for many
/// tiny ones; null for no one.
inline void fall_between_walls(double& x, double& velocity, double acceleration, double dt, double length,
                               HitSpeeds* hits = nullptr) {
  const double low = time_to_wall(x, velocity, acceleration, 0, -1);
  const double high = time_to_wall(x, velocity, acceleration, length, 1);
  if (const double hit = std::min(low, high); hit < dt) {
    velocity = -(velocity + acceleration * hit);
    x = low < high ? 0 : length;
    const double across = time_to_wall(x, velocity, acceleration, length - x, low < high ? 1 : -1);
    const double period = 2 * (across < HUGE_VAL ? across : std::fabs(velocity / acceleration));
    const double left = dt - hit, speed = std::fabs(velocity);
    if (!(period > 0)) {  // at rest on the wall that it is pressed to
      velocity = 0;
      if (hits != nullptr) hits->add(high <= low, std::fabs(acceleration) * left / 2);
      return;
    }
    dt = std::fmod(left, period);
    if (hits != nullptr) {
      const double periods = std::round((left - dt) / period);
      hits->add(high <= low, (1 + periods) * speed);
      if (across < HUGE_VAL)
        hits->add(low < high, (periods + (dt > across)) * std::fabs(velocity + acceleration * across));
    }
    if (dt > across) {
      velocity = -(velocity + acceleration * across);
      x = length - x;
      dt -= across;
    }
  }
  x = std::max(0.0, std::min(length, x + dt * (velocity + 0.5 * acceleration * dt)));
  velocity += acceleration * dt;
}

}  // namespace sandglass
