#include "sim/scene/method/family.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// Reports what the scene asks of a method that cannot do it, and names the methods that can.
class Refusals {
 public:
  Refusals(const Scene& scene, Diagnostics& diagnostics)
      : can(capabilities(scene)), method_(scene.method.preset), diagnostics_(diagnostics) {}

  void when(bool wrong, const std::string& path, const std::string& reason) {
    if (wrong && diagnostics_.clean(path)) diagnostics_.report(path, reason);
  }
  /// "'obstacle' cannot be used with the method 'x', only with 'y'; remove it"
  void unable(bool used, const std::string& path, bool (*able)(const Capabilities&),
              const std::string& remedy = "remove it", const std::string& subject = "") {
    if (used && !able(can))
      when(true, path,
           (subject.empty() ? shown(path) : subject) + " cannot be used with the method '" + method_ +
               "', only with " + presets_that(able) + "; " + remedy);
  }
  /// "'initial.exact' cannot be used: the method 'x' holds no particles; remove it"
  void without(bool used, bool ability, const std::string& path, const std::string& lack) {
    when(used && !ability, path, shown(path) + " cannot be used: the method '" + method_ + "' " + lack);
  }

  bool reported(const std::string& path) const { return !diagnostics_.clean(path); }

  const Capabilities& can;

 private:
  std::string method_;
  Diagnostics& diagnostics_;
};

std::string rule_remedy(const Capabilities& can) {
  std::vector<std::string> names;
  for (const SurfaceKind kind : can.wall_rules) names.push_back(word_of(surface_kind_words(), kind));
  return "use " + list_words(names);
}

void check_surface(const SurfaceRule& surface, const std::string& path, Refusals& refusals) {
  const auto& rules = refusals.can.wall_rules;
  const bool known = std::find(rules.begin(), rules.end(), surface.rule) != rules.end();
  refusals.without(!known, false, path + ".rule", "knows no such rule; " + rule_remedy(refusals.can));
  refusals.unable(surface.tangential_restitution != -1, path + ".tangential-restitution",
                  [](const Capabilities& can) { return can.spins; });
}

void check_boundaries(const Scene& scene, Refusals& refusals) {
  bool walled = false;
  for (const auto& sides : scene.domain.sides) walled |= sides[0] != Side::periodic;
  const auto can_wall = [](const Capabilities& can) { return can.walls; };
  refusals.unable(walled, "domain.sides", can_wall);
  const auto can_vary = [](const Capabilities& can) { return can.varying_number; };
  for (std::size_t axis = 0; can_wall(refusals.can) && axis < scene.domain.sides.size(); ++axis) {
    const auto& sides = scene.domain.sides[axis];
    refusals.unable(sides[0] == Side::open || sides[1] == Side::open,
                    "domain.sides." + axis_words()[axis].first, can_vary, "use \"specular\" or \"periodic\"",
                    "a side that lets particles out");
  }
  const auto can_rule = [](const Capabilities& can) { return !can.wall_rules.empty(); };
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (can_rule(refusals.can)) check_surface(scene.walls[i].surface, item_path("wall", i), refusals);
  }
  refusals.unable(!scene.walls.empty(), "wall", can_rule, "plain specular walls need no [[wall]]: remove it");
  const auto can_obstacle = [](const Capabilities& can) { return can.obstacles; };
  refusals.unable(!scene.obstacles.empty(), "obstacle", can_obstacle);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    if (can_obstacle(refusals.can))
      check_surface(scene.obstacles[i].surface, item_path("obstacle", i), refusals);
  refusals.unable(!scene.regions.empty(), "region", [](const Capabilities& can) { return can.regions; });
  refusals.unable(!scene.sources.empty(), "source", can_vary);
  refusals.unable(!scene.inflows.empty(), "inflow", can_vary);
  refusals.unable(
      !scene.outflows.empty(), "outflow", [](const Capabilities& can) { return can.outflows; },
      "an [[inflow]] at that side with the velocity of the stream sends back as many on average");
  refusals.unable(!scene.gravity.empty(), "forces.gravity",
                  [](const Capabilities& can) { return can.gravity; });
}

void check_particles(const Scene& scene, Refusals& refusals) {
  refusals.unable(
      scene.species.size() > 1, "species[1]", [](const Capabilities& can) { return can.species; },
      "remove this table", "more than one species");
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    refusals.unable(scene.species[i].tangential_restitution != -1,
                    item_path("species", i) + ".tangential-restitution",
                    [](const Capabilities& can) { return can.spins; });
  refusals.without(scene.method.weight != 1, refusals.can.weights, "method.weight",
                   "takes every particle for a real one: it must be 1");
}

/// Particles are placed, and may overlap. Nobody does in a box that starts empty.
bool overlaps(const Scene& scene) {
  const Positions positions = scene.initial.positions;
  return scene.given.empty() && particle_count(scene) > 0 &&
         (positions == Positions::random || positions == Positions::barometric);
}

/// What needs particles in a box.
void check_contents(const Scene& scene, Refusals& refusals) {
  const Initial plain;
  const Initial& initial = scene.initial;
  const auto without = [&](bool used, const std::string& path) {
    refusals.without(used, refusals.can.particles, path, "holds no particles; remove it");
  };
  without(!scene.given.empty(), "particle");
  without(initial.positions != plain.positions, "initial.positions");
  without(!initial.exact, "initial.exact");
  without(initial.shear_wave.has_value(), "initial.shear-wave");
  without(scene.output.trajectory.has_value(), "output.trajectory");
  without(scene.output.ids, "output.ids");
  refusals.without(scene.output.checkpoint.has_value(), refusals.can.restartable, "output.checkpoint",
                   "has no state to keep; remove it");
  refusals.unable(
      scene.method.time_step.cell_fraction.has_value(), "method.time-step.cell-fraction",
      [](const Capabilities& can) { return can.cells; }, "give a time");
  refusals.unable(scene.output.event_trace.has_value(), "output.event-trace",
                  [](const Capabilities& can) { return can.event_trace; });
  refusals.when(scene.output.event_trace && scene.output.event_trace->empty(), "output.event-trace",
                "'output.event-trace' is empty; name a file");
  refusals.when(refusals.can.contacts && overlaps(scene) && !refusals.reported("particle"),
                "initial.positions",
                "positions = \"random\" (the default) lets hard particles overlap; use \"lattice\" or "
                "\"random-without-overlap\" with the method '" +
                    scene.method.preset + "'");
}

/// What counts collisions, where there are none to count.
void check_counts(const Scene& scene, bool able, const std::string& reason, Diagnostics& diagnostics) {
  const auto refuse = [&](bool used, const std::string& path) {
    if (used && !able && diagnostics.clean(path)) diagnostics.report(path, shown(path) + ' ' + reason);
  };
  refuse(scene.run.duration.collisions.has_value(), "run.duration");
  refuse(scene.method.time_step.collisions.has_value(), "method.time-step");
  for (std::size_t i = 0; i < scene.observe.size(); ++i)
    refuse(scene.observe[i].cadence.unit == Cadence::Unit::collisions, item_path("observe", i) + ".every");
}

/// One particle has neither a partner nor a temperature about its own mean velocity.
void check_single(const Scene& scene, Diagnostics& diagnostics) {
  for (const char* path : {"domain", "species", "method", "particle"})
    if (!diagnostics.clean(path)) return;
  if (particle_count(scene) != 1) return;
  if (scene.given.empty() && scene.initial.exact && diagnostics.clean("initial.exact"))
    diagnostics.report("initial.exact",
                       "'initial.exact' cannot serve a single particle, whose mean velocity is its own: use "
                       "exact = false or positions = \"given\"");
  check_counts(scene, false, "cannot serve a single particle, which collides with none: use a time or steps",
               diagnostics);
}
}  // namespace

void check_capabilities(const Scene& scene, Diagnostics& diagnostics) {
  Refusals refusals(scene, diagnostics);
  check_boundaries(scene, refusals);
  check_particles(scene, refusals);
  check_contents(scene, refusals);
  const Capabilities& can = refusals.can;
  check_counts(scene, can.collisions,
               "counts collisions, and the method '" + scene.method.preset +
                   "' has no collisions to count: use a time or steps",
               diagnostics);
  check_counts(scene, scene.regions.empty(),
               "counts collisions of particles alike, and with a [[region]] each stands for another number "
               "of real ones: use a time or steps",
               diagnostics);
  if (scene.initial.equilibrate_collisions != 0)
    refusals.without(true, can.collisions, "initial.equilibrate-collisions-per-particle",
                     "has no collisions; remove it");
  if (can.contacts) check_single(scene, diagnostics);
}

}  // namespace sandglass
