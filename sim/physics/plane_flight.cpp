#include "sim/physics/plane_flight.hpp"

#include "sim/base/error.hpp"
#include "sim/physics/first_approach.hpp"

namespace sandglass {
namespace {

/// From at or below zero, on the way up.
double time_to_fall_back(const Arc& arc) {
  if (arc.acceleration >= 0) return kNever;
  // An arc that does not get above zero turns at its apex.
  const double discriminant = arc.speed * arc.speed - 2 * arc.acceleration * arc.place;
  return (arc.speed + std::sqrt(std::max(0.0, discriminant))) / -arc.acceleration;
}

/// Time at which an arc below zero that rises gets to zero.
double time_to_emerge(const Arc& arc) { return time_to_fall({-arc.place, -arc.speed, -arc.acceleration}); }

/// Two periods from now on. The slope of the gap is monotone between the times at which the plane's acceleration is the
/// particle's.
double meeting_within_two_periods(const Arc& gap, const PlaneMotion& plane) {
  const double omega = plane.angular_frequency(), period = 1 / std::fabs(plane.frequency);
  const double sine = -gap.acceleration / (plane.amplitude * omega * omega);
  double nodes[6] = {};
  std::size_t count = 0;
  if (std::fabs(sine) < 1)
    for (const double angle : {std::asin(sine), M_PI - std::asin(sine)}) {
      const double time = std::fmod((angle - plane.phase) / omega, period);
      nodes[count++] = time < 0 ? time + period : time;
      nodes[count++] = time < 0 ? time + 2 * period : time + period;
    }
  count = closed_nodes(nodes, count, 2 * period);
  return first_approach(
      [&](double t) { return gap.at(t) - plane.amplitude * std::sin(plane.angle(t)); },
      [&](double t) { return gap.speed_at(t) - plane.amplitude * omega * std::cos(plane.angle(t)); },
      [&](double t) { return gap.acceleration - plane.acceleration_at(t); }, {nodes, count});
}

/// Deep below a vibrating plane and rising faster than it: nothing can happen before this time.
double time_to_surface(const Arc& gap, double amplitude, double fastest) {
  const double emerged = time_to_emerge({gap.place + amplitude, gap.speed, gap.acceleration});
  const double slowed = gap.acceleration < 0 ? (fastest - gap.speed) / gap.acceleration : kNever;
  return std::max(0.0, std::min(emerged, slowed));
}

}  // namespace

double time_to_fall(const Arc& arc) {
  const auto [place, speed, acceleration] = arc;
  if (place <= 0) {
    if (speed < 0 || (speed == 0 && acceleration < 0)) return 0;
    return time_to_fall_back(arc);
  }
  if (speed >= 0 && acceleration >= 0) return kNever;
  if (acceleration == 0) return -place / speed;
  const double discriminant = speed * speed - 2 * acceleration * place;
  if (discriminant < 0) return kNever;
  const double root = std::sqrt(discriminant);
  return speed > 0 ? (speed + root) / -acceleration : 2 * place / (root - speed);
}

double time_to_plane(const Arc& particle, const PlaneMotion& plane) {
  const Arc gap{particle.place - plane.position, particle.speed - plane.speed, particle.acceleration};
  SANDGLASS_EXPECT(!std::isnan(gap.place + gap.speed + gap.acceleration + plane.phase));
  if (!plane.vibrates())
    return time_to_fall({gap.place - plane.amplitude * std::sin(plane.phase), gap.speed, gap.acceleration});
  // They touch at -amplitude <= gap <= amplitude only, and within a period of getting there or not before the gap has opened
  // again: a few periods are all that must be searched.
  const double amplitude = std::fabs(plane.amplitude);
  const double fastest = amplitude * std::fabs(plane.angular_frequency());
  const double starts[] = {gap.place <= amplitude ? 0 : kNever,
                           gap.place < -amplitude ? time_to_surface(gap, amplitude, fastest) : kNever,
                           time_to_fall({gap.place - amplitude, gap.speed, gap.acceleration})};
  for (const double start : starts) {
    if (!std::isfinite(start)) continue;
    const double event = meeting_within_two_periods(gap.from(start), plane.from(start));
    if (event < kNever) return start + event;
  }
  return kNever;
}

}  // namespace sandglass
