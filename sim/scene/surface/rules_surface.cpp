#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::string side_of(const Wall& wall) { return word_of(wall_side_words(), std::pair{wall.axis, wall.high}); }

void check_surface(const SurfaceRule& surface, const std::string& path, Diagnostics& diagnostics) {
  check_bounds(diagnostics, path + ".restitution", surface.restitution, between(0, 1));
  check_rough(surface.tangential_restitution, surface.friction, path, diagnostics);
  check_bounds(diagnostics, path + ".probability", surface.probability, between(0, 1));
  if (surface.rule == SurfaceKind::thermal && diagnostics.clean(path + ".temperature"))
    check_bounds(diagnostics, path + ".temperature", surface.temperature, positive());
}

/// Where the wall stands: a side of its own, not periodic. False when that is not known.
bool check_place(const Scene& scene, std::size_t index, const std::string& path, Diagnostics& diagnostics) {
  const Wall& wall = scene.walls[index];
  const std::string side = path + ".side";
  if (!diagnostics.clean(side)) return false;
  if (!check_side(scene.domain, wall.axis, wall.high, side, diagnostics)) return false;
  const auto axis = static_cast<std::size_t>(wall.axis);
  if (scene.domain.sides[axis][0] == Side::periodic)
    diagnostics.report(
        side, fmt::format("{} is '{}', but {} is periodic; put walls there: [domain.sides] {} = "
                          "\"specular\"",
                          shown(side), side_of(wall), axis_words()[axis].first, axis_words()[axis].first));
  if (scene.domain.sides[axis][wall.high] == Side::open)
    diagnostics.report(side, fmt::format("{} is '{}', which is open; remove this table, or put a wall there: "
                                         "[domain.sides] {} = \"specular\"",
                                         shown(side), side_of(wall), axis_words()[axis].first));
  for (std::size_t i = 0; i < index; ++i)
    if (scene.walls[i].axis == wall.axis && scene.walls[i].high == wall.high)
      diagnostics.report(path, fmt::format("two tables [[wall]] name '{}'; keep one", side_of(wall)));
  return true;
}

void check_vibration(const Wall& wall, const std::string& path, Diagnostics& diagnostics) {
  if (wall.amplitude == 0 && wall.frequency == 0) return;
  if (!diagnostics.clean(path + ".amplitude") || !diagnostics.clean(path + ".frequency")) return;
  if (check_bounds(diagnostics, path + ".amplitude", wall.amplitude, positive()))
    check_bounds(diagnostics, path + ".frequency", wall.frequency, positive());
}

void check_velocity(const Wall& wall, int dimension, const std::string& path, Diagnostics& diagnostics) {
  if (wall.velocity.empty() || !diagnostics.clean(path + ".velocity")) return;
  check_vector(diagnostics, path + ".velocity", wall.velocity, dimension, speed());
  if (wall.velocity.size() != static_cast<std::size_t>(dimension)) return;
  if (wall.amplitude != 0 && diagnostics.clean(path + ".side") &&
      wall.velocity[static_cast<std::size_t>(wall.axis)] != 0)
    diagnostics.report(path + ".velocity",
                       shown(path + ".velocity") +
                           " moves the plane that 'amplitude' and 'frequency' move; give one of the two");
}

/// Both planes at their innermost leave room for the largest particle.
void check_room(const Scene& scene, std::size_t axis, Diagnostics& diagnostics) {
  double swing = 0;
  std::string path;
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (scene.walls[i].axis != static_cast<int>(axis) || scene.walls[i].amplitude == 0) continue;
    swing += scene.walls[i].amplitude;
    path = item_path("wall", i) + ".amplitude";
  }
  const double room = scene.domain.size[axis] - swing;
  if (path.empty() || room > largest_diameter(scene) || !diagnostics.clean("wall")) return;
  diagnostics.report(
      path, fmt::format("the walls along {} swing by {} in all and leave no room for a particle "
                        "of diameter {} in {}; lower {}",
                        axis_words()[axis].first, swing, largest_diameter(scene), scene.domain.size[axis],
                        shown(path)));
}

/// A particle must be able to pass on every side, and no obstacle stands on a seam.
void check_place(const Scene& scene, const Obstacle& obstacle, const std::string& path,
                 Diagnostics& diagnostics) {
  const double reach = obstacle.radius + largest_diameter(scene);
  for (std::size_t axis = 0; axis < obstacle.centre.size(); ++axis) {
    const double low = obstacle.centre[axis] - reach, high = obstacle.centre[axis] + reach;
    if (low >= 0 && high <= scene.domain.size[axis]) continue;
    diagnostics.report(item_path(path + ".centre", axis),
                       fmt::format("{} is {} along {}; an obstacle of radius {} needs a largest particle's "
                                   "diameter to each edge: allowed: {} to {}",
                                   shown(path + ".centre"), obstacle.centre[axis], axis_words()[axis].first,
                                   obstacle.radius, reach, scene.domain.size[axis] - reach));
  }
}

void check_obstacle(const Scene& scene, const Obstacle& obstacle, const std::string& path,
                    Diagnostics& diagnostics) {
  check_surface(obstacle.surface, path, diagnostics);
  if (!diagnostics.clean(path + ".centre") || !diagnostics.clean(path + ".radius")) return;
  bool good = check_bounds(diagnostics, path + ".radius", obstacle.radius, moderate());
  good &= check_length(diagnostics, path + ".centre", obstacle.centre.size(), scene.domain.dimension);
  for (std::size_t axis = 0; axis < obstacle.centre.size(); ++axis)
    good &= check_bounds(diagnostics, item_path(path + ".centre", axis), obstacle.centre[axis], finite());
  if (good && diagnostics.clean("species")) check_place(scene, obstacle, path, diagnostics);
}
}  // namespace

bool check_side(const Domain& domain, int axis, bool high, const std::string& path,
                Diagnostics& diagnostics) {
  if (axis >= 0 && axis < domain.dimension) return true;
  diagnostics.report(path, fmt::format("{} is '{}', but the domain of 2 dimensions has the axes x and y",
                                       shown(path), word_of(wall_side_words(), std::pair{axis, high})));
  return false;
}

void check_walls(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const std::string path = item_path("wall", i);
    check_surface(scene.walls[i].surface, path, diagnostics);
    check_vibration(scene.walls[i], path, diagnostics);
    if (check_place(scene, i, path, diagnostics))
      check_velocity(scene.walls[i], scene.domain.dimension, path, diagnostics);
  }
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) check_room(scene, axis, diagnostics);
}

void check_obstacles(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    check_obstacle(scene, scene.obstacles[i], item_path("obstacle", i), diagnostics);
}

}  // namespace sandglass
