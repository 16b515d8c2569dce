#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
void check_sides(const Domain& domain, Diagnostics& diagnostics) {
  for (std::size_t axis = 0; axis < domain.sides.size(); ++axis) {
    const auto& [low, high] = domain.sides[axis];
    const std::string path = "domain.sides." + axis_words()[axis].first;
    if ((low == Side::periodic) == (high == Side::periodic) || !diagnostics.clean(path)) continue;
    diagnostics.report(path,
                       fmt::format("{} has one periodic side and one wall; an axis is periodic on both sides "
                                   "or on none",
                                   shown(path)));
  }
}
}  // namespace

void check_domain(const Scene& scene, Diagnostics& diagnostics) {
  const Domain& domain = scene.domain;
  if (!check_bounds(diagnostics, "domain.dimension", domain.dimension, between(2, 3))) return;
  if (diagnostics.clean("domain.size")) {
    check_length(diagnostics, "domain.size", domain.size.size(), domain.dimension);
    for (std::size_t axis = 0; axis < domain.size.size(); ++axis)
      check_bounds(diagnostics, item_path("domain.size", axis), domain.size[axis], positive());
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
    const std::string& name = axis_words()[axis].first;
    diagnostics.report(
        path, fmt::format("gravity acts along the periodic axis {0}: particles would fall for ever and "
                          "gain energy without bound; put walls there: [domain.sides] {0} = \"specular\"",
                          name));
  }
}

}  // namespace sandglass
