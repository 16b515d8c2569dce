#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/law/free_molecular.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_gamma.h>

// Drag on an obstacle in free flight, from the momentum that the gas loses. As long as nobody comes round through
// the periodic images, each point of the obstacle sees the Maxwellian of the start: the force is constant from
// time zero.

namespace sandglass {

namespace {
/// The axis of the stream; -1 when there is none or it is oblique.
int stream_axis(const Scene& scene) {
  int found = -1;
  for (std::size_t axis = 0; axis < scene.initial.velocity.size(); ++axis) {
    if (scene.initial.velocity[axis] == 0) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(axis);
  }
  return found;
}

bool has_law(const SurfaceRule& surface) {
  return surface.restitution == 1 && surface.tangential_restitution == -1 &&
         surface.rule != SurfaceKind::random_tangential_sign;
}

bool is_obstacle_in_stream(const Scene& scene) {
  if (!is_plain_gas(scene) || !is_weightless(scene) || stream_axis(scene) < 0) return false;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (!is_periodic_along(scene, axis)) return false;
  return scene.obstacles.size() == 1 && has_law(scene.obstacles.front().surface) &&
         collisions_along(scene, scene.obstacles.front().radius) < 0.1;
}

double covered(int dimension, double radius) {
  const double square = std::numbers::pi * radius * radius;
  return dimension == 2 ? square : 4 * square * radius / 3;
}

law::StreamPastObstacle stream_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const SurfaceRule& surface = scene.obstacles.front().surface;
  law::StreamPastObstacle stream;
  stream.dimension = subject.dimension();
  stream.mass = subject.species().mass;
  stream.temperature = scene.initial.temperature;
  stream.velocity = scene.initial.velocity[static_cast<std::size_t>(stream_axis(scene))];
  stream.radius = scene.obstacles.front().radius + reach(scene);
  const double all = volume(scene.domain);
  stream.number_density =
      number_density(scene, subject.species()) * all / (all - covered(stream.dimension, stream.radius));
  stream.accommodation = surface.rule == SurfaceKind::thermal ? 1 : 0;
  stream.reversal = surface.rule == SurfaceKind::bounce_back ? surface.probability : 0;
  stream.surface_temperature =
      surface.rule == SurfaceKind::thermal ? surface.temperature : stream.temperature;
  return stream;
}

/// Force on the obstacle over the run: momentum lost over the time that it took.
double force(const Subject& subject, std::size_t replica) {
  const Series& series = subject.series(replica, "momentum");
  const std::string axis =
      series.quantity.components.at(static_cast<std::size_t>(stream_axis(subject.scene())));
  const std::vector<double> momentum = subject.column(replica, "momentum", axis);
  if (momentum.size() < 2)
    throw InputError("the momentum is sampled once: sample it at the start and the end");
  return (momentum.front() - momentum.back()) / (series.time.back() - series.time.front());
}

/// Momentum carried by particles fast enough to fly from the obstacle to an image of it (before they hit, or
/// after) as a share of all: the tail of a Maxwellian weighted with the square of the velocity, counted twice.
double came_round(const Subject& subject, const law::StreamPastObstacle& stream) {
  const std::vector<double>& size = subject.scene().domain.size;
  const double gap = *std::min_element(size.begin(), size.end()) - 2 * stream.radius;
  const std::vector<double>& time = subject.series(0, "momentum").time;
  const double speed = gap / (time.back() - time.front()) - std::abs(stream.velocity);
  if (speed <= 0) return 1;
  const double hottest = std::max(stream.temperature, stream.surface_temperature);
  return std::min(
      1.0, 2 * gsl_sf_gamma_inc_Q(stream.dimension / 2.0 + 1, stream.mass * speed * speed / (2 * hottest)));
}

Evidence obstacle_drag(const Subject& subject, const law::Arguments&) {
  std::vector<double> forces;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    forces.push_back(force(subject, replica));
  const law::StreamPastObstacle stream = stream_of(subject);
  Evidence evidence = from_mean(mean_of_independent(forces), law::free_molecular_drag(stream));
  evidence.units = "mass length time^-2";
  const std::vector<double>& time = subject.series(0, "momentum").time;
  const double share = came_round(subject, stream) +
                       collisions_in(subject.scene(), time.back() - time.front()) + 2 / subject.particles();
  evidence.budget.systematic = share * std::abs(evidence.expected);
  evidence.budget.reason =
      "particles fast enough to come round through the images; collisions on the way; finite N";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> drag_checks() {
  return {{"obstacle-drag",
           "momentum that a stream loses to a fixed disk or sphere, per time, against free flight",
           "free-molecular-drag",
           {"momentum"},
           true,
           {},
           is_obstacle_in_stream,
           obstacle_drag}};
}

}  // namespace sandglass
