#include "sim/base/spelling.hpp"
#include "sim/scene/bounds.hpp"
#include "sim/scene/catalogue.hpp"
#include "sim/scene/rules.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double least_corrected =
    0.1;  // the corrected offset is d (1 + r) / (2 r): 5.5 d here, no bound below

void check_time_step(const TimeStep& step, Diagnostics& diagnostics) {
  const std::string path = "method.time-step";
  if (step.fixed.has_value() == step.collisions.has_value() && diagnostics.clean(path))
    diagnostics.report(path,
                       "'method.time-step' needs a time or { collisions-per-particle }, one of the two");
  if (step.fixed) check_bounds(diagnostics, path, *step.fixed, positive());
  if (step.collisions)
    check_bounds(diagnostics, path + ".collisions-per-particle", *step.collisions, positive());
}

void check_offset(const Scene& scene, Diagnostics& diagnostics) {
  const Method& method = scene.method;
  check_bounds(diagnostics, "method.random-offset", method.random_offset, between(0, 10));
  if (method.random_offset != 0 && method.offset != Offset::random)
    diagnostics.report("method.random-offset",
                       "'method.random-offset' is used with offset = \"random\" only");
  if (method.offset != Offset::corrected) return;
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    const double restitution = scene.species[i].restitution;
    if (!(restitution >= 0 && restitution < least_corrected)) continue;
    const std::string path = item_path("species", i) + ".restitution";
    diagnostics.report(
        path, fmt::format("{} is {}; with offset = \"corrected\" at least {} is allowed, since the offset "
                          "d (1 + r) / (2 r) has no bound as r goes to 0",
                          shown(path), restitution, least_corrected));
  }
}

void check_guard(const Method& method, Diagnostics& diagnostics) {
  const auto check = [&](const std::string& key, double value, CollapseGuard user) {
    const std::string path = "method." + key;
    if (!diagnostics.clean(path)) return;
    if (method.guard == user)
      check_bounds(diagnostics, path, value, positive());
    else if (value != 0)
      diagnostics.report(path, shown(path) + " is not used by this collapse guard; leave it at 0");
  };
  check("contact-time", method.contact_time, CollapseGuard::contact_time);
  check("reference-speed", method.reference_speed, CollapseGuard::velocity_dependent);
}
}  // namespace

void check_method(const Scene& scene, Diagnostics& diagnostics) {
  const Method& method = scene.method;
  if (!find_preset(method.preset))
    diagnostics.report("method.preset", unknown_word("preset", method.preset, preset_names()));
  if (method.density != DensityEstimate::smoothed && method.contact_factor == ContactFactor::none)
    diagnostics.report("method.density", "'method.density' is used with contact-factor = \"local\" only");
  check_offset(scene, diagnostics);
  check_time_step(method.time_step, diagnostics);
  check_guard(method, diagnostics);
  check_bounds(diagnostics, "method.weight", method.weight, positive());
  if (method.cell_size) check_bounds(diagnostics, "method.cell-size", *method.cell_size, positive());
}

}  // namespace sandglass
