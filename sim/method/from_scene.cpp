#include "sim/method/from_scene.hpp"

#include <limits>

namespace sandglass {

namespace {
constexpr double kSticks = std::numeric_limits<double>::infinity();

WallKind kind_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::specular:
      return WallKind::specular;
    case SurfaceKind::bounce_back:
      return WallKind::bounce_back;
    case SurfaceKind::random_tangential_sign:
      return WallKind::random_tangential_sign;
    case SurfaceKind::thermal:
      return WallKind::thermal;
  }
  return WallKind::specular;
}
}  // namespace

double reference_speed(const Scene& scene) { return guard_of(scene.method).reference_speed; }

Surface surface_of(const Scene& scene, const Species& species) {
  return {{species.restitution, reference_speed(scene)},
          species.tangential_restitution,
          species.friction.value_or(kSticks)};
}

std::vector<SpeciesTraits> traits_of(const Scene& scene) {
  std::vector<SpeciesTraits> all;
  for (const Species& species : scene.species) {
    const double radius = species.diameter / 2;
    all.push_back({species.diameter, species.mass,
                   inertia_factor(species, scene.domain.dimension) * species.mass * radius * radius});
  }
  return all;
}

std::vector<Surface> surfaces_of(const Scene& scene) {
  std::vector<Surface> all;
  for (const Species& species : scene.species)
    for (const Species& other : scene.species)
      all.push_back(mix(surface_of(scene, species), surface_of(scene, other)));
  return all;
}

WallRule wall_rule_of(const Scene& scene, const SurfaceRule& surface) {
  WallRule rule;
  rule.kind = kind_of(surface.rule);
  rule.surface = {{surface.restitution, reference_speed(scene)},
                  surface.tangential_restitution,
                  surface.friction.value_or(kSticks)};
  rule.probability = surface.probability;
  rule.temperature = surface.temperature;
  return rule;
}

Wall wall_of(const Scene& scene, int axis, bool high) {
  for (const Wall& wall : scene.walls)
    if (wall.axis == axis && wall.high == high) return wall;
  Wall plain;
  plain.axis = axis;
  plain.high = high;
  return plain;
}

}  // namespace sandglass
