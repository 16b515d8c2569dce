#include "sim/scene/bounds.hpp"
#include "sim/scene/catalogue.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/words.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
/// A box shorter than this would let a particle meet two images of another.
constexpr double least_periodic_diameters = 4;
constexpr std::size_t most_species = 255;  // a particle keeps its species in one byte

struct Faults {
  Diagnostics& diagnostics;
  std::string subject;
  void when(bool fault, const std::string& path, const std::string& reason) {
    if (fault && diagnostics.clean(path)) diagnostics.report(path, shown(path) + ' ' + subject + reason);
  }
};

/// What no other method of this version can do.
void check_others(const Scene& scene, Diagnostics& diagnostics) {
  Faults faults{diagnostics, "is for the method 'event-driven' only"};
  const Method plain;
  faults.when(scene.method.guard != plain.guard, "method.collapse-guard", "; remove it");
  faults.when(!scene.walls.empty(), "wall", "; plain specular walls need no [[wall]]: remove it");
  faults.when(!scene.obstacles.empty(), "obstacle", "; remove it");
  faults.when(scene.output.event_trace.has_value(), "output.event-trace", "; remove it");
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    faults.when(scene.species[i].tangential_restitution != -1,
                item_path("species", i) + ".tangential-restitution",
                ": particles of the other methods are smooth (-1); remove it");
  if (scene.species.size() > 1 && diagnostics.clean("species[1]"))
    diagnostics.report("species[1]",
                       "more than one species; in this version only the method 'event-driven' "
                       "takes several: remove this table");
}

void check_choices(const Method& method, Diagnostics& diagnostics) {
  Faults faults{diagnostics, "is not used by the method 'event-driven'"};
  faults.when(method.contact_factor != ContactFactor::none, "method.contact-factor",
              ", whose collisions are exact; remove it");
  faults.when(method.density != DensityEstimate::smoothed, "method.density", "; remove it");
  faults.when(method.offset != Offset::none, "method.offset", ", whose particles never jump; remove it");
  faults.when(!method.cells.empty(), "method.cells", ", which chooses its cells itself; remove it");
  faults.when(method.cell_size.has_value(), "method.cell-size",
              ", which chooses its cells itself; remove it");
  faults.when(method.weight != 1, "method.weight", ", where every particle is a real one: it must be 1");
}

void check_box(const Scene& scene, Diagnostics& diagnostics) {
  if (!diagnostics.clean("domain") || !diagnostics.clean("species")) return;
  const double diameter = largest_diameter(scene);
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    const bool periodic = scene.domain.sides[axis][0] == Side::periodic;
    const double least = periodic ? least_periodic_diameters * diameter : diameter;
    const double edge = scene.domain.size[axis];
    if (periodic ? edge >= least : edge > least) continue;
    const std::string path = item_path("domain.size", axis);
    diagnostics.report(
        path, fmt::format("{} is {} along {}; with the method 'event-driven' a {} axis must be {} {} long, {}"
                          "the largest diameter: use a larger domain or smaller particles",
                          shown(path), edge, axis_words()[axis].first, periodic ? "periodic" : "walled",
                          periodic ? "at least" : "more than", least, periodic ? "4 times " : ""));
  }
}

/// One particle has neither a partner nor a temperature about its own mean velocity.
void check_single(const Scene& scene, Diagnostics& diagnostics) {
  const bool clean = diagnostics.clean("domain") && diagnostics.clean("species") &&
                     diagnostics.clean("method") && diagnostics.clean("particle");
  if (!clean || particle_count(scene) != 1) return;
  Faults faults{diagnostics, "cannot serve a single particle"};
  faults.when(scene.given.empty() && scene.initial.exact, "initial.exact",
              ", whose mean velocity is its own: use exact = false or positions = \"given\"");
  const std::string reason = ", which meets no other: use a time or steps";
  faults.when(scene.run.duration.collisions.has_value(), "run.duration", reason);
  faults.when(scene.method.time_step.collisions.has_value(), "method.time-step", reason);
  for (std::size_t i = 0; i < scene.observe.size(); ++i)
    faults.when(scene.observe[i].cadence.unit == Cadence::Unit::collisions,
                item_path("observe", i) + ".every", reason);
}

void check_own(const Scene& scene, Diagnostics& diagnostics) {
  check_choices(scene.method, diagnostics);
  check_box(scene, diagnostics);
  check_single(scene, diagnostics);
  if (scene.species.size() > most_species)
    diagnostics.report(item_path("species", most_species),
                       fmt::format("{} species; at most {} are allowed", scene.species.size(), most_species));
  if (scene.given.empty() && diagnostics.clean("particle") && diagnostics.clean("initial.positions") &&
      scene.initial.positions == Positions::random)
    diagnostics.report("initial.positions",
                       "positions = \"random\" (the default) lets hard particles overlap; use \"lattice\" or "
                       "\"random-without-overlap\" with the method 'event-driven'");
  if (scene.output.event_trace && scene.output.event_trace->empty())
    diagnostics.report("output.event-trace", "'output.event-trace' is empty; name a file");
}
}  // namespace

void check_event_driven(const Scene& scene, Diagnostics& diagnostics) {
  if (is_event_driven(scene))
    check_own(scene, diagnostics);
  else
    check_others(scene, diagnostics);
}

}  // namespace sandglass
