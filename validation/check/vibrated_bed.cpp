#include "validation/check/vibrated_bed.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/free_flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass {

namespace {
std::size_t vertical(const Scene& scene) { return static_cast<std::size_t>(vertical_axis(scene)); }

/// Product of the edges across gravity, and the largest of them.
struct Footprint {
  double area = 1, width = 0;
};

Footprint footprint_of(const Scene& scene) {
  Footprint footprint;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    if (axis == vertical(scene)) continue;
    footprint.area *= scene.domain.size[axis];
    footprint.width = std::max(footprint.width, scene.domain.size[axis]);
  }
  return footprint;
}
}  // namespace

bool is_vibrated_bed(const Scene& scene) {
  if (vertical_axis(scene) < 0 || scene.species.size() != 1 || is_rough(scene)) return false;
  if (!capabilities(scene).collisions || !scene.obstacles.empty() || !scene.sources.empty()) return false;
  return wall_at(scene, vertical(scene), false).amplitude > 0;
}

law::VibratedBed bed_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const Wall bottom = wall_at(scene, vertical(scene), false);
  const Footprint footprint = footprint_of(scene);
  law::VibratedBed bed;
  bed.dimension = subject.dimension();
  bed.layers = (subject.particles() - 1) * scene.method.weight *
               std::pow(subject.species().diameter, bed.dimension - 1) / footprint.area;
  bed.width = footprint.width;
  bed.restitution = subject.species().restitution;
  bed.bottom_restitution = bottom.surface.restitution;
  bed.side_restitution = wall_at(scene, 0, false).surface.restitution;
  bed.gravity = -scene.gravity[vertical(scene)];
  bed.speed = 2 * std::numbers::pi * bottom.amplitude * bottom.frequency;
  return bed;
}

std::string vertical_name(const Scene& scene) { return scene.domain.dimension == 2 ? "y" : "z"; }

double settled_from(const Subject& subject, const law::Arguments& numbers) {
  const std::string what = subject.has("centre-of-mass") ? "centre-of-mass" : "wall-force";
  return numbers.at("settle-share") * subject.series(0, what).time.back();
}

Mean bed_height(const Subject& subject, double from) {
  std::vector<std::vector<double>> heights;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    heights.push_back(late_samples(subject, replica, "centre-of-mass", vertical_name(subject.scene()), from));
  return pooled(heights);
}

}  // namespace sandglass
