#include "validation/check/column.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/law/isolated_column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass {

namespace {
/// Does work on nobody, and leaves spins alone.
bool keeps_at_rest(const SurfaceRule& surface) {
  return surface.rule == SurfaceKind::thermal ||
         (surface.restitution == 1 && surface.tangential_restitution == -1);
}

std::vector<SurfaceRule> surfaces_of(const Scene& scene) {
  std::vector<SurfaceRule> surfaces;
  for (const Wall& wall : scene.walls) surfaces.push_back(wall.surface);
  for (const Obstacle& obstacle : scene.obstacles) surfaces.push_back(obstacle.surface);
  return surfaces;
}

bool are_alike_warm(const std::vector<SurfaceRule>& surfaces) {
  const SurfaceRule* first = nullptr;
  for (const SurfaceRule& surface : surfaces) {
    if (surface.rule != SurfaceKind::thermal) continue;
    if (first != nullptr && surface.temperature != first->temperature) return false;
    first = &surface;
  }
  return true;
}

law::Column column_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const auto axis = static_cast<std::size_t>(vertical_axis(scene));
  return {subject.species().mass, subject.mean_temperature(), -scene.gravity[axis], scene.domain.size[axis]};
}

/// Of the box, what obstacles leave.
double free_share(const Subject& subject) {
  double covered = 0;
  for (const Obstacle& obstacle : subject.scene().obstacles) {
    const double square = std::numbers::pi * obstacle.radius * obstacle.radius;
    covered += subject.dimension() == 2 ? square : 4 * square * obstacle.radius / 3;
  }
  return 1 - covered / volume(subject.scene().domain);
}

/// Particles in the emptiest of the bins, by the law.
double fewest_in_a_bin(const law::Column& column, double bins, double particles) {
  return particles * (1 - law::barometric_fraction(column, column.height * (1 - 1 / bins)));
}

/// Largest of the shifts of density and temperature, at the height where each shows most: a bin lies between such heights.
struct Shifts {
  double density = 0, temperature = 0;
};

/// N particles that collide and share one energy.
Shifts of_few(const law::Column& column, const Subject& subject) {
  const law::IsolatedColumn shifts(column, subject.dimension(), subject.particles());
  Shifts most;
  for (const double z : {0.0, shifts.largest_density_height(), column.height}) {
    most.density = std::max(most.density, std::abs(shifts.density_shift(z)));
    most.temperature = std::max(most.temperature, std::abs(shifts.temperature_shift(z)));
  }
  return most;
}

/// Where particles have a size, or partners are displaced by one, the floor holds fewer.
double of_size(const law::Column& column, const Subject& subject) {
  if (!touches(subject.scene()) && !loses_pairs(subject.scene())) return 0;
  const double excluded = law::excluded_fraction(subject.gas(1)) / free_share(subject);
  double most = 0;
  for (const double z : {0.0, column.height})
    most = std::max(most, std::abs(law::excluded_volume_shift(column, excluded, z)));
  return most;
}
}  // namespace

bool is_column(const Scene& scene) {
  const int up = vertical_axis(scene);
  return is_plain_gas(scene) && up >= 0 && !is_periodic_along(scene, static_cast<std::size_t>(up)) &&
         std::ranges::all_of(scene.walls, is_still) &&
         std::ranges::all_of(surfaces_of(scene), keeps_at_rest) && are_alike_warm(surfaces_of(scene));
}

std::optional<double> temperature_of_surfaces(const Scene& scene) {
  for (const SurfaceRule& surface : surfaces_of(scene))
    if (surface.rule == SurfaceKind::thermal) return surface.temperature;
  return std::nullopt;
}

std::vector<double> column_temperatures(const Subject& subject, double from) {
  const auto set = temperature_of_surfaces(subject.scene());
  std::vector<double> temperatures;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    temperatures.push_back(
        set ? *set : mean_of_independent(late_samples(subject, replica, "temperature", "total", from)).value);
  return temperatures;
}

double mean_over(std::span<const std::size_t> replicas, const std::vector<double>& values) {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += values[replica];
  return sum / static_cast<double>(replicas.size());
}

law::ObstructedColumn column_at(const Subject& subject, double temperature) {
  const Scene& scene = subject.scene();
  const auto axis = static_cast<std::size_t>(vertical_axis(scene));
  const double away = reach(scene);
  law::ObstructedColumn column{
      {subject.species().mass, temperature, -scene.gravity[axis], scene.domain.size[axis] - 2 * away},
      subject.dimension(),
      1,
      {}};
  for (std::size_t other = 0; other < scene.domain.size.size(); ++other)
    if (other != axis)
      column.area *= scene.domain.size[other] - (is_periodic_along(scene, other) ? 0 : 2 * away);
  for (const Obstacle& obstacle : scene.obstacles)
    column.obstacles.push_back({obstacle.centre[axis] - away, obstacle.radius + away});
  return column;
}

double column_shift(const Subject& subject, double bins) {
  if (!capabilities(subject.scene()).collisions) return 0;
  const law::Column column = column_of(subject);
  const Shifts few = temperature_of_surfaces(subject.scene()) ? Shifts{} : of_few(column, subject);
  const double fewest = fewest_in_a_bin(column, bins, subject.particles());
  return std::max(few.temperature * law::weight_of_crowded_samples(fewest),
                  few.density + of_size(column, subject));
}

}  // namespace sandglass
