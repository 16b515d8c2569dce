#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

namespace sandglass {

/// Tangential restitution and friction of a species or a surface.
void check_rough(double tangential_restitution, const std::optional<double>& friction,
                 const std::string& path, Diagnostics& diagnostics) {
  check_bounds(diagnostics, path + ".tangential-restitution", tangential_restitution, between(-1, 1));
  if (!friction) return;
  check_bounds(diagnostics, path + ".friction", *friction, at_least(0));
  if (tangential_restitution == -1 && diagnostics.clean(path + ".tangential-restitution"))
    diagnostics.report(path + ".friction",
                       shown(path + ".friction") +
                           " needs 'tangential-restitution' above -1: a contact of -1 (the "
                           "default) is smooth and has no tangential force");
}

/// Values that concern spins, in a scene where none can change.
void check_spins(const Scene& scene, Diagnostics& diagnostics) {
  if (is_rough(scene)) return;
  const auto refuse = [&diagnostics](bool wrong, const std::string& path) {
    if (wrong && diagnostics.clean(path))
      diagnostics.report(path, shown(path) +
                                   " needs rough contacts: give 'tangential-restitution' above -1 to "
                                   "a species, wall or obstacle");
  };
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    refuse(scene.species[i].inertia_factor.has_value(), item_path("species", i) + ".moment-of-inertia");
  refuse(scene.initial.spin_temperature != 0, "initial.spin-temperature");
  for (std::size_t i = 0; i < scene.inflows.size(); ++i)
    refuse(scene.inflows[i].spin_temperature != 0, item_path("inflow", i) + ".spin-temperature");
  for (std::size_t i = 0; i < scene.given.size(); ++i)
    refuse(!scene.given[i].spin.empty(), item_path("particle", i) + ".spin");
}

}  // namespace sandglass
