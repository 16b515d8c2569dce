#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/worst.hpp"
#include "validation/law/free_molecular.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

// A gas between two thermal walls that hardly collides: temperature along each axis and density at each place.

namespace sandglass {

namespace {
/// The axis between two thermal walls, the others periodic; -1 when the scene is not like that.
int axis_between_walls(const Scene& scene) {
  int found = -1;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    if (is_periodic_along(scene, axis)) continue;
    if (found >= 0 || !is_thermal_at_rest(wall_at(scene, axis, false)) ||
        !is_thermal_at_rest(wall_at(scene, axis, true)))
      return -1;
    found = static_cast<int>(axis);
  }
  return found;
}

bool is_between_thermal_walls(const Scene& scene) {
  if (!is_plain_gas(scene) || !is_weightless(scene) || !scene.obstacles.empty()) return false;
  const int axis = axis_between_walls(scene);
  return axis >= 0 && collisions_along(scene, scene.domain.size[static_cast<std::size_t>(axis)]) < 0.1;
}

struct WallsAndGas {
  std::size_t axis;
  double low, high;  ///< temperatures of the walls
  double gas;        ///< temperature by the law
};

WallsAndGas walls_of(const Scene& scene) {
  const auto axis = static_cast<std::size_t>(axis_between_walls(scene));
  const double low = wall_at(scene, axis, false).surface.temperature;
  const double high = wall_at(scene, axis, true).surface.temperature;
  return {axis, low, high, law::knudsen_temperature(low, high)};
}

/// Mean of 1/t over the samples used, times a length: the largest speed that has not crossed it.
double slow_speed(const Subject& subject, double from) {
  const std::vector<double>& time = subject.series(0, "temperature").time;
  double sum = 0, samples = 0;
  for (const double t : time)
    if (t >= from && t > 0) sum += 1 / t, ++samples;
  return sum / samples;
}

/// Share of particles that are still, or that would already be, on a flight longer than the run: density of
/// normal velocities at zero (of the start, and of the two half-Maxwellians) times the speed, times one half
/// for flights that began between the walls. The temperature of each is off by its own size or by that of the
/// hottest.
double not_yet_settled(const Subject& subject, const WallsAndGas& walls, double from) {
  const double mass = subject.species().mass;
  const auto peak = [&](double temperature) {
    return std::sqrt(mass / (2 * std::numbers::pi * temperature));
  };
  const double cold_share = std::sqrt(walls.high) / (std::sqrt(walls.low) + std::sqrt(walls.high));
  const double settled = cold_share * peak(walls.low) + (1 - cold_share) * peak(walls.high);
  const double start = peak(subject.scene().initial.temperature);
  const double hottest = std::max({walls.low, walls.high, subject.scene().initial.temperature});
  return (start + settled) * subject.scene().domain.size[walls.axis] * slow_speed(subject, from) *
         std::max(1.0, hottest / walls.gas - 1);
}

void offer_temperatures(const Subject& subject, const WallsAndGas& walls, double from, WorstRatio& worst) {
  const std::vector<std::string>& axes = subject.series(0, "temperature").quantity.components;
  for (std::size_t axis = 0; axis + 1 < axes.size(); ++axis) {
    std::vector<std::vector<double>> samples;
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
      samples.push_back(late_samples(subject, replica, "temperature", axes[axis], from));
    Mean mean = pooled(samples);
    mean.value /= walls.gas;
    mean.standard_error /= walls.gas;
    worst.offer(mean, "temperature along " + axes[axis]);
  }
}

Figure offer_densities(const Subject& subject, const WallsAndGas& walls, double from, WorstRatio& worst) {
  std::vector<Profile> profiles;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    profiles.push_back(profile_along(subject, replica, walls.axis, from));
  const std::size_t bins = profiles.front().density.size();
  const double mean_density = number_density(subject.scene(), subject.species());
  Figure figure{
      "Density between the walls", {"distance", "length", false}, {"density over mean", "1", false}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, std::vector<double>(bins, 1.0)};
  for (std::size_t bin = 0; bin < bins; ++bin) {
    std::vector<double> ratios;
    for (const Profile& profile : profiles) ratios.push_back(profile.density[bin] / mean_density);
    const Mean mean = mean_of_independent(ratios);
    worst.offer(mean, fmt::format("density in bin {}", bin));
    points.x.push_back((static_cast<double>(bin) + 0.5) * subject.scene().domain.size[walls.axis] /
                       static_cast<double>(bins));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  figure.points.push_back(std::move(points));
  return figure;
}

Evidence gas_between_walls(const Subject& subject, const law::Arguments& numbers) {
  const double from = numbers.at("settle-time");
  const WallsAndGas walls = walls_of(subject.scene());
  WorstRatio worst;
  offer_temperatures(subject, walls, from, worst);
  Figure figure = offer_densities(subject, walls, from, worst);
  Evidence evidence = worst.evidence();
  evidence.summary =
      "temperature along each axis and density in each bin over the Knudsen limit; worst: " + worst.label();
  const double length = subject.scene().domain.size[walls.axis];
  const double bins = static_cast<double>(figure.points.front().x.size());
  evidence.budget.systematic = not_yet_settled(subject, walls, from) +
                               collisions_along(subject.scene(), length) +
                               bins * reach(subject.scene()) / length;
  evidence.budget.reason =
      "particles too slow to have reached a wall since the start; collisions on the way; layers that a "
      "radius keeps free";
  evidence.figures.push_back(std::move(figure));
  return evidence;
}
}  // namespace

std::vector<CheckInfo> knudsen_checks() {
  return {{"gas-between-walls",
           "temperature along each axis and density in each bin between two thermal walls, over the Knudsen "
           "limit",
           "knudsen-temperature",
           {"temperature", "fields"},
           true,
           {law::Parameter{"settle-time", "time", "samples before it are left out", 0, 1e12}},
           is_between_thermal_walls,
           gas_between_walls}};
}

}  // namespace sandglass
