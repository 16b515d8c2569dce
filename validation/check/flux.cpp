#include "validation/law/flux.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/histogram.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
enum class Way { up, down };

const Observe& plane_of(const Scene& scene) {
  for (const Observe& observe : scene.observe)
    if (observe.what == "crossings") return observe;
  throw InputError("the scene has no observer 'crossings': add it and run again");
}

law::Stream stream_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const auto axis = static_cast<std::size_t>(plane_of(scene).axis);
  const double velocity = scene.initial.velocity.empty() ? 0 : scene.initial.velocity.at(axis);
  return {number_density(scene, subject.species()), subject.species().mass, scene.initial.temperature,
          velocity};
}

double plane_area(const Scene& scene) {
  double area = 1;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (static_cast<int>(axis) != plane_of(scene).axis) area *= scene.domain.size[axis];
  return area;
}

/// Real particles per area and time over each interval between samples.
std::vector<double> interval_fluxes(const Subject& subject, std::size_t replica, const std::string& way) {
  const std::vector<double> time = subject.series(replica, "crossing-count").time;
  const std::vector<double> count = subject.column(replica, "crossing-count", way);
  const double unit = subject.scene().method.weight / plane_area(subject.scene());
  std::vector<double> fluxes;
  for (std::size_t i = 1; i < time.size(); ++i)
    fluxes.push_back(unit * (count[i] - count[i - 1]) / (time[i] - time[i - 1]));
  return fluxes;
}

/// Share of the plane that the radius of particles keeps free along walls: it makes the rest denser.
double free_layers(const Scene& scene) {
  double share = 0;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (!is_periodic_along(scene, axis)) share += 2 * reach(scene) / scene.domain.size[axis];
  return share;
}

bool keeps_temperature(const Scene& scene, const Wall& wall) {
  return is_thermal_at_rest(wall) && wall.surface.temperature == scene.initial.temperature;
}

/// A gas in equilibrium whatever collides: periodic, or at rest between walls at its own temperature.
bool is_stationary(const Scene& scene) {
  if (is_uniform(scene)) return true;
  if (!is_plain_gas(scene) || !is_weightless(scene) || !scene.obstacles.empty()) return false;
  for (const double velocity : scene.initial.velocity)
    if (velocity != 0) return false;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    for (const bool high : {false, true})
      if (!is_periodic_along(scene, axis) && !keeps_temperature(scene, wall_at(scene, axis, high)))
        return false;
  return true;
}

Evidence flux_rate(const Subject& subject, Way way) {
  std::vector<std::vector<double>> fluxes;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    fluxes.push_back(interval_fluxes(subject, replica, way == Way::up ? "up" : "down"));
  const Mean flux = pooled(fluxes);
  const law::Stream stream = stream_of(subject);
  Evidence evidence =
      from_mean(flux, way == Way::up ? law::flux_forward(stream) : law::flux_backward(stream));
  evidence.units = "length^(1-D) time^-1";
  if (!capabilities(subject.scene()).particles) return evidence;
  evidence.budget.systematic = (2 / subject.particles() + free_layers(subject.scene())) * evidence.expected;
  evidence.budget.reason = "finite N: moments of a sphere instead of a Gaussian";
  if (free_layers(subject.scene()) > 0)
    evidence.budget.reason += "; layers along walls that a radius keeps free";
  return evidence;
}

/// The first bin that moves up: the edges are symmetric with one at zero.
std::size_t first_upward_bin(const std::vector<double>& edges) {
  const auto zero =
      std::find_if(edges.begin(), edges.end(), [&](double edge) { return edge > -1e-9 * edges.back(); });
  if (zero == edges.end() || *zero > 1e-9 * edges.back())
    throw InputError(
        "the bins of 'crossings' have no edge at zero: use a symmetric range and an even number of bins");
  return static_cast<std::size_t>(zero - edges.begin());
}

Evidence flux_distribution(const Subject& subject, Way way) {
  const law::Stream stream = stream_of(subject);
  const BlockedHistogram all = blocked_histogram(subject, "crossings");
  const std::size_t middle = first_upward_bin(all.edges);
  const BlockedHistogram part =
      way == Way::up ? part_of(all, middle, all.edges.size() - 1) : part_of(all, 0, middle);
  const auto cumulative = [&](double velocity) {
    return way == Way::up ? law::flux_cumulative_forward(stream, velocity)
                          : law::flux_cumulative_backward(stream, velocity);
  };
  return compare_histogram(part, cumulative, {"normal velocity", "length/time", false});
}

CheckInfo rate_check(const std::string& name, const std::string& direction, const std::string& law, Way way) {
  return {"flux-rate-" + name,
          "particles that cross a plane " + direction + ", per area and time",
          law,
          {"crossing-count"},
          true,
          {},
          is_stationary,
          [way](const Subject& subject, const law::Arguments&) { return flux_rate(subject, way); }};
}

CheckInfo distribution_check(const std::string& name, const std::string& direction, const std::string& law,
                             Way way) {
  return {"flux-distribution-" + name,
          "normal velocities of the particles that cross a plane " + direction,
          law,
          {"crossings"},
          true,
          {},
          is_stationary,
          [way](const Subject& subject, const law::Arguments&) { return flux_distribution(subject, way); }};
}
}  // namespace

std::vector<CheckInfo> flux_checks() {
  return {rate_check("up", "towards larger coordinates", "flux-forward", Way::up),
          rate_check("down", "towards smaller coordinates", "flux-backward", Way::down),
          distribution_check("up", "towards larger coordinates", "flux-density-forward", Way::up),
          distribution_check("down", "towards smaller coordinates", "flux-density-backward", Way::down)};
}

}  // namespace sandglass
