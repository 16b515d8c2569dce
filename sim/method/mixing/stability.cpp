#include "sim/method/mixing/stability.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::mixing {

namespace {
constexpr int kIntervals = 4000;

/// Relative acceleration of two particles.
double pull_apart(const Repulsion& repulsion, double mass, double distance) {
  return distance < repulsion.cutoff ? mass * repulsion.per_separation(distance) * distance : 0;
}

double stiffness(const Repulsion& repulsion, double mass, double distance) {
  const double width = 1e-4 * distance;
  return std::abs(pull_apart(repulsion, mass, distance + width) -
                  pull_apart(repulsion, mass, distance - width)) /
         (2 * width);
}

/// The largest relative velocity that the start can hold: twice the fastest particle.
double starting_speed(const Scene& scene) {
  double fastest = 0;
  for (const GivenParticle& particle : scene.given)
    fastest = std::max(fastest, std::hypot(particle.velocity[0], particle.velocity[1]));
  if (scene.initial.uniform_velocity) fastest = std::max(fastest, M_SQRT2 * *scene.initial.uniform_velocity);
  return 2 * fastest;
}
}  // namespace

/// From a diameter inwards on a geometric ladder: the stiffness rises inwards, but for a softened core has its largest
/// value at rest in the middle.
double unstable_distance(const Repulsion& repulsion, double mass, double dt) {
  const double limit = 4 / (dt * dt);
  for (int i = 1; i <= kIntervals; ++i) {
    const double distance = 0.999 * repulsion.diameter * std::exp(-20.0 * i / kIntervals);
    if (stiffness(repulsion, mass, distance) > limit) return distance;
  }
  return 0;
}

/// Half the square of the speed is the work, here by the midpoint rule over the logarithm of the distance.
double speed_to_reach(const Repulsion& repulsion, double mass, double distance) {
  const double far = std::min(repulsion.cutoff, 100 * repulsion.diameter);
  if (!(distance < far)) return 0;
  const double step = std::log(far / distance) / kIntervals;
  double work = 0;
  for (int i = 0; i < kIntervals; ++i) {
    const double r = distance * std::exp((i + 0.5) * step);
    work += pull_apart(repulsion, mass, r) * r * step;
  }
  return std::sqrt(2 * work);
}

std::string stability_warning(const Scene& scene, const Parameters& parameters) {
  double heaviest = 0;
  for (const SpeciesTraits& species : parameters.species) heaviest = std::max(heaviest, species.mass);
  const double dt = scene.method.time_step.fixed.value_or(0);
  const double distance = unstable_distance(parameters.repulsion, 2 * heaviest, dt);
  if (!(distance > 0)) return {};
  const double speed = speed_to_reach(parameters.repulsion, 2 * heaviest, distance);
  if (starting_speed(scene) < speed) return {};
  return fmt::format(
      "two of the heaviest particles may start fast enough ({:.3g}; {:.3g} suffices) to come nearer than "
      "{:.3g}, "
      "where the time step is beyond 2/omega of their repulsion: such pairs gain energy; lower "
      "'method.time-step'",
      starting_speed(scene), speed, distance);
}

}  // namespace sandglass::mixing
