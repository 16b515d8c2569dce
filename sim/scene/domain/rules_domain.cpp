#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
void check_sides(const Domain& domain, Diagnostics& diagnostics) {
  for (std::size_t axis = 0; axis < domain.sides.size(); ++axis) {
    const auto& [low, high] = domain.sides[axis];
    const std::string path = "domain.sides." + axis_words()[axis].first;
    if ((low == Side::periodic) == (high == Side::periodic) || !diagnostics.clean(path)) continue;
    diagnostics.report(
        path, fmt::format("{} has one periodic side and one {}; an axis is periodic on both sides "
                          "or on none",
                          shown(path), low == Side::open || high == Side::open ? "open one" : "wall"));
  }
}
/// A rule that changes the velocity along the surface.
bool drags(const SurfaceRule& surface) {
  return surface.rule == SurfaceKind::thermal || surface.rule == SurfaceKind::random_tangential_sign ||
         (surface.rule == SurfaceKind::bounce_back && surface.probability > 0) ||
         surface.tangential_restitution > -1;
}

/// Contacts that take energy: normally, or along the surface, which a perfectly smooth or rough one does not without
/// friction.
template <class Contact>
bool dissipates(const Contact& contact) {
  return contact.restitution < 1 ||
         (contact.tangential_restitution > -1 && (contact.tangential_restitution < 1 || contact.friction));
}

/// All rules that particles meet at a surface.
std::vector<SurfaceRule> surfaces_of(const Scene& scene) {
  std::vector<SurfaceRule> surfaces;
  for (const Wall& wall : scene.walls) surfaces.push_back(wall.surface);
  for (const Obstacle& obstacle : scene.obstacles) surfaces.push_back(obstacle.surface);
  return surfaces;
}

/// Momentum along a periodic axis goes to walls that drag and to obstacles.
bool holds_momentum(const Scene& scene) {
  return !scene.obstacles.empty() || std::any_of(scene.walls.begin(), scene.walls.end(),
                                                 [](const Wall& wall) { return drags(wall.surface); });
}

/// Energy goes to thermal surfaces, or is lost in contacts. Without collisions between particles it is lost of the normal
/// motion alone, and the fall goes on.
bool holds_energy(const Scene& scene) {
  const std::vector<SurfaceRule> surfaces = surfaces_of(scene);
  const auto thermal = [](const SurfaceRule& surface) { return surface.rule == SurfaceKind::thermal; };
  if (std::any_of(surfaces.begin(), surfaces.end(), thermal)) return true;
  return capabilities(scene).collisions &&
         (std::any_of(scene.species.begin(), scene.species.end(), dissipates<Species>) ||
          std::any_of(surfaces.begin(), surfaces.end(), dissipates<SurfaceRule>));
}

/// What particles gain in an endless fall must go somewhere.
void check_endless_fall(const Scene& scene, const std::string& path, const std::string& axis,
                        Diagnostics& diagnostics) {
  for (const char* other : {"wall", "obstacle", "species", "method.preset"})
    if (!diagnostics.clean(other)) return;
  const std::string fall =
      "gravity acts along the periodic axis " + axis + ": particles would fall for ever and ";
  const std::string floor = ", or put walls there: [domain.sides] " + axis + " = \"specular\"";
  if (!holds_momentum(scene))
    diagnostics.report(
        path, fall +
                  "gain momentum without bound; give a [[wall]] across another axis a rule that acts "
                  "along it (\"bounce-back\", \"random-tangential-sign\" or \"thermal\"), "
                  "place an [[obstacle]]" +
                  floor);
  else if (!holds_energy(scene))
    diagnostics.report(path,
                       fall + "gain energy without bound; " +
                           (capabilities(scene).collisions ? "lower a 'restitution' below 1 or use"
                                                           : "without collisions between particles use") +
                           " a wall with rule = \"thermal\"" + floor);
}
}  // namespace

void check_domain(const Scene& scene, Diagnostics& diagnostics) {
  const Domain& domain = scene.domain;
  if (!check_bounds(diagnostics, "domain.dimension", domain.dimension, between(2, 3))) return;
  if (diagnostics.clean("domain.size")) {
    check_length(diagnostics, "domain.size", domain.size.size(), domain.dimension);
    for (std::size_t axis = 0; axis < domain.size.size(); ++axis)
      check_bounds(diagnostics, item_path("domain.size", axis), domain.size[axis], moderate());
  }
  if (check_length(diagnostics, "domain.sides", domain.sides.size(), domain.dimension))
    check_sides(domain, diagnostics);
}

void check_gravity(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.gravity.empty()) return;
  if (!check_length(diagnostics, "forces.gravity", scene.gravity.size(), scene.domain.dimension)) return;
  const bool sides_known = diagnostics.clean("domain.sides");
  for (std::size_t axis = 0; axis < scene.gravity.size(); ++axis) {
    const std::string path = item_path("forces.gravity", axis);
    if (!check_bounds(diagnostics, path, scene.gravity[axis], finite())) continue;
    if (!sides_known || scene.gravity[axis] == 0 || scene.domain.sides[axis][0] != Side::periodic) continue;
    check_endless_fall(scene, path, axis_words()[axis].first, diagnostics);
  }
}

}  // namespace sandglass
