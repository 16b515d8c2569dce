#include "sim/scene/catalogue.hpp"
#include "sim/scene/rules.hpp"

namespace sandglass {

namespace {
/// A reservoir holds no particles: what speaks of particles in a box has no meaning for it.
struct Faults {
  Diagnostics& diagnostics;
  void when(bool fault, const std::string& path, const std::string& reason) {
    if (fault && diagnostics.clean(path))
      diagnostics.report(path, "the method 'reservoir' draws an ideal-gas stream and " + reason);
  }
};

void check_stream(const Scene& scene, Faults& faults) {
  if (!scene.species.empty())
    faults.when(!scene.species.front().number_density, "species[0]",
                "needs 'number-density' for its density");
  for (std::size_t axis = 0; axis < scene.domain.sides.size(); ++axis)
    faults.when(scene.domain.sides[axis][0] != Side::periodic, "domain.sides",
                "has no walls; remove [domain.sides]");
  faults.when(!scene.given.empty(), "particle", "has no particles; remove them");
  faults.when(!scene.gravity.empty(), "forces.gravity", "knows no gravity; remove it");
  const Initial plain;
  const Initial& initial = scene.initial;
  faults.when(initial.positions != plain.positions, "initial.positions", "has no positions; remove it");
  faults.when(!initial.exact, "initial.exact", "has no initial particles to scale; remove it");
  faults.when(initial.shear_wave.has_value(), "initial.shear-wave", "is uniform; remove the shear wave");
  faults.when(initial.equilibrate_collisions != 0, "initial.equilibrate-collisions-per-particle",
              "has no collisions; remove it");
}

void check_choices(const Method& method, Faults& faults) {
  faults.when(method.contact_factor != ContactFactor::none, "method.contact-factor",
              "has no collisions; remove it");
  faults.when(method.offset != Offset::none, "method.offset", "has no collisions; remove it");
  faults.when(!method.cells.empty(), "method.cells", "has no cells; remove them");
  faults.when(method.cell_size.has_value(), "method.cell-size", "has no cells; remove it");
  faults.when(!method.time_step.fixed, "method.time-step",
              "needs a fixed time step, for example time-step = 0.1");
}

void check_outcome(const Scene& scene, Faults& faults) {
  faults.when(scene.observe.empty(), "observe", "needs the observer 'crossings'");
  for (std::size_t i = 0; i < scene.observe.size(); ++i) {
    faults.when(scene.observe[i].what != "crossings", item_path("observe", i) + ".what",
                "accepts the observer 'crossings' only");
    faults.when(scene.observe[i].cadence.unit == Cadence::Unit::collisions,
                item_path("observe", i) + ".every", "has no collisions to count; use time or steps");
  }
  faults.when(scene.run.duration.collisions.has_value(), "run.duration",
              "has no collisions to count; use time or steps");
  faults.when(scene.output.trajectory.has_value(), "output.trajectory",
              "has no particles to write; remove it");
  faults.when(scene.output.ids, "output.ids", "has no particles to number; remove it");
  faults.when(scene.output.checkpoint.has_value(), "output.checkpoint", "has no state to keep; remove it");
}
}  // namespace

void check_reservoir(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.method.preset != reservoir_preset) return;
  Faults faults{diagnostics};
  check_stream(scene, faults);
  check_choices(scene.method, faults);
  check_outcome(scene, faults);
}

}  // namespace sandglass
