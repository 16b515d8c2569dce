#include "sim/base/spelling.hpp"
#include "sim/scene/method/family.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>

namespace sandglass {

namespace {
void check_time_step(const TimeStep& step, Diagnostics& diagnostics) {
  const std::string path = "method.time-step";
  const int given = step.fixed.has_value() + step.collisions.has_value() + step.cell_fraction.has_value();
  if (given != 1 && diagnostics.clean(path))
    diagnostics.report(
        path, "'method.time-step' needs one of a time, { collisions-per-particle } and { cell-fraction }");
  if (step.fixed) check_bounds(diagnostics, path, *step.fixed, positive());
  if (step.collisions)
    check_bounds(diagnostics, path + ".collisions-per-particle", *step.collisions, positive());
  if (step.cell_fraction &&
      check_bounds(diagnostics, path + ".cell-fraction", *step.cell_fraction, positive()) &&
      *step.cell_fraction > 1)
    diagnostics.report(path + ".cell-fraction", shown(path + ".cell-fraction") +
                                                    " is above 1: particles would "
                                                    "jump over cells; allowed: above 0, to 1");
}

/// A scene made in code may name one family's preset beside another's options.
void check_preset(const Method& method, Diagnostics& diagnostics) {
  const std::vector<Preset>& own = family_of(method).presets;
  if (std::ranges::find(own, method.preset, &Preset::name) != own.end()) return;
  const std::vector<std::string> names = preset_names();
  const bool known = std::find(names.begin(), names.end(), method.preset) != names.end();
  diagnostics.report("method.preset", known ? "'method.preset' is '" + method.preset +
                                                  "', but the options are those of the family '" +
                                                  family_of(method).name + "'; use choose()"
                                            : unknown_word("preset", method.preset, names));
}
}  // namespace

void check_method(const Scene& scene, Diagnostics& diagnostics) {
  check_preset(scene.method, diagnostics);
  check_time_step(scene.method.time_step, diagnostics);
  check_bounds(diagnostics, "method.weight", scene.method.weight, moderate());
}

void check_family(const Scene& scene, Diagnostics& diagnostics) {
  family_of(scene.method).check(scene, diagnostics);
}

}  // namespace sandglass
