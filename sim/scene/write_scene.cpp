#include "sim/scene/method/family.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/words.hpp"
#include "sim/scene/write_sections.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
void write_run(Lines& lines, const Run& run) {
  lines.header("[run]");
  lines.add("seed", run.seed);
  lines.add("replicas", run.replicas);
  lines.add("duration", run.duration);
}

void write_domain(Lines& lines, const Domain& domain) {
  lines.header("[domain]");
  lines.add("dimension", domain.dimension);
  lines.add("size", domain.size);
  lines.header("[domain.sides]");
  for (std::size_t axis = 0; axis < domain.sides.size(); ++axis) {
    const auto& [low, high] = domain.sides[axis];
    lines.add(axis_words()[axis].first, std::vector{word_of(side_words(), low), word_of(side_words(), high)});
  }
}

void write_species(Lines& lines, const Species& species, int dimension) {
  lines.header("[[species]]");
  lines.add("name", species.name);
  lines.add("count", species.count);
  lines.add(fraction_key(dimension), species.fraction);
  lines.add("number-density", species.number_density);
  lines.add("diameter", species.diameter);
  lines.add("mass", species.mass);
  lines.add("restitution", species.restitution);
  lines.add("tangential-restitution", species.tangential_restitution);
  lines.add("friction", species.friction);
  lines.add("moment-of-inertia", species.inertia_factor);
}

void write_method(Lines& lines, const Scene& scene) {
  const Method& method = scene.method;
  lines.header("[method]");
  lines.add("preset", method.preset);
  family_of(method).write(lines, method.options);
  lines.add("time-step", method.time_step);
  lines.add("weight", method.weight);
}

void write_initial(Lines& lines, const Scene& scene) {
  const Initial& initial = scene.initial;
  const bool given = !scene.given.empty();
  lines.header("[initial]");
  lines.add("positions", word_of(positions_words(), given ? std::nullopt : std::optional(initial.positions)));
  if (given && initial.velocity_rounding > 0) lines.add("velocity-rounding", initial.velocity_rounding);
  if (given) return;
  lines.add("uniform-velocity", initial.uniform_velocity);
  if (!initial.uniform_velocity) lines.add("temperature", initial.temperature);
  if (!initial.velocity.empty()) lines.add("velocity", initial.velocity);
  if (!initial.uniform_velocity) lines.add("exact", initial.exact);
  lines.add("shear-wave", initial.shear_wave);
  lines.add("equilibrate-collisions-per-particle", initial.equilibrate_collisions);
  lines.add("spin-temperature", initial.spin_temperature);
}

void write_observe(Lines& lines, const Observe& observe) {
  const auto uses = [&observe](const char* key) { return observer_uses(observe.what, key); };
  lines.header("[[observe]]");
  lines.add("what", observe.what);
  lines.add("every", observe.cadence);
  lines.add("start", observe.start);
  if (uses("axis")) lines.add("axis", word_of(axis_words(), observe.axis));
  if (uses("position")) lines.add("position", observe.position);
  if (uses("range")) lines.add("range", observe.range);
  if (uses("bins")) lines.add("bins", observe.bins);
  if (uses("grid")) lines.add("grid", observe.grid);
}

void write_output(Lines& lines, const Output& output) {
  lines.header("[output]");
  lines.add("record", output.record);
  lines.add("trajectory", output.trajectory);
  lines.add("ids", output.ids);
  lines.add("checkpoint", output.checkpoint);
  lines.add("event-trace", output.event_trace);
}
}  // namespace

std::string write_scene(const Scene& scene) {
  Lines lines;
  lines.add("title", scene.title);
  write_run(lines, scene.run);
  write_domain(lines, scene.domain);
  for (const Species& species : scene.species) write_species(lines, species, scene.domain.dimension);
  for (const Wall& wall : scene.walls) write_wall(lines, wall);
  for (const Obstacle& obstacle : scene.obstacles) write_obstacle(lines, obstacle);
  for (const Source& source : scene.sources) write_source(lines, source);
  for (const Inflow& inflow : scene.inflows) write_inflow(lines, inflow, scene);
  for (const Region& region : scene.regions) write_region(lines, region);
  for (const Outflow& outflow : scene.outflows) write_outflow(lines, outflow);
  write_method(lines, scene);
  if (!scene.gravity.empty()) {
    lines.header("[forces]");
    lines.add("gravity", scene.gravity);
  }
  write_initial(lines, scene);
  for (const GivenParticle& particle : scene.given) write_particle(lines, particle, scene);
  for (const Observe& observe : scene.observe) write_observe(lines, observe);
  write_output(lines, scene.output);
  return lines.text();
}

}  // namespace sandglass
