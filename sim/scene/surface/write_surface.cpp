#include "sim/scene/words.hpp"
#include "sim/scene/write_sections.hpp"

namespace sandglass {

namespace {
/// Only what the rule uses: the reader refuses the rest.
void write_surface(Lines& lines, const SurfaceRule& surface) {
  lines.add("rule", word_of(surface_kind_words(), surface.rule));
  if (surface.rule == SurfaceKind::thermal) return lines.add("temperature", surface.temperature);
  lines.add("restitution", surface.restitution);
  if (surface.rule == SurfaceKind::bounce_back) lines.add("probability", surface.probability);
  if (surface.rule != SurfaceKind::specular) return;
  lines.add("tangential-restitution", surface.tangential_restitution);
  lines.add("friction", surface.friction);
}
}  // namespace

void write_wall(Lines& lines, const Wall& wall) {
  lines.header("[[wall]]");
  lines.add("side", word_of(wall_side_words(), std::pair{wall.axis, wall.high}));
  write_surface(lines, wall.surface);
  if (!wall.velocity.empty()) lines.add("velocity", wall.velocity);
  if (wall.amplitude == 0) return;
  lines.add("amplitude", wall.amplitude);
  lines.add("frequency", wall.frequency);
}

void write_obstacle(Lines& lines, const Obstacle& obstacle) {
  lines.header("[[obstacle]]");
  lines.add("centre", obstacle.centre);
  lines.add("radius", obstacle.radius);
  write_surface(lines, obstacle.surface);
}

void write_particle(Lines& lines, const GivenParticle& particle, const Scene& scene) {
  lines.header("[[particle]]");
  lines.add("position", particle.position);
  lines.add("velocity", particle.velocity);
  if (particle.spin.size() == 1)
    lines.add("spin", particle.spin.front());
  else if (!particle.spin.empty())
    lines.add("spin", particle.spin);
  lines.add("species", scene.species.at(particle.species).name);
}

}  // namespace sandglass
