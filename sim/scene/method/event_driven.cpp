#include "sim/scene/method/event_driven.hpp"

#include "sim/scene/method/family.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <fmt/format.h>

namespace sandglass {

const Words<CollapseGuard>& guard_words() {
  static const Words<CollapseGuard> words = {{"none", CollapseGuard::none},
                                             {"contact-time", CollapseGuard::contact_time},
                                             {"velocity-dependent", CollapseGuard::velocity_dependent}};
  return words;
}

namespace {
/// A box shorter than this would let a particle touch two images of another.
constexpr double least_periodic_diameters = 4;
constexpr std::size_t most_species = 255;  // a particle keeps its species in one byte

/// A number that one guard needs and the others do not use.
void read_guard_number(Table& table, const std::string& key, CollapseGuard guard, CollapseGuard user,
                       double& target, const std::string& remedy) {
  if (!table.clean("collapse-guard"))
    table.skip(key);
  else if (guard == user)
    table.require(key, target, remedy);
  else
    table.refuse(key, "is used with collapse-guard = \"" + word_of(guard_words(), user) +
                          "\" only; the guard here is \"" + word_of(guard_words(), guard) + '"');
}

void read(Table& table, MethodOptions& options) {
  Guard& guard = std::get<EventDrivenOptions>(options).guard;
  table.read_word("collapse-guard", "collapse guard", guard.kind, guard_words());
  read_guard_number(table, "contact-time", guard.kind, CollapseGuard::contact_time, guard.contact_time,
                    "time after a collision for which the next is elastic");
  read_guard_number(table, "reference-speed", guard.kind, CollapseGuard::velocity_dependent,
                    guard.reference_speed, "normal speed below which the restitution goes to 1");
}

void write(Lines& lines, const MethodOptions& options) {
  const Guard& guard = std::get<EventDrivenOptions>(options).guard;
  lines.add("collapse-guard", word_of(guard_words(), guard.kind));
  if (guard.kind == CollapseGuard::contact_time) lines.add("contact-time", guard.contact_time);
  if (guard.kind == CollapseGuard::velocity_dependent) lines.add("reference-speed", guard.reference_speed);
}

void check_guard(const Guard& guard, Diagnostics& diagnostics) {
  const auto check = [&](const std::string& key, double value, CollapseGuard user) {
    const std::string path = "method." + key;
    if (!diagnostics.clean(path)) return;
    if (guard.kind == user)
      check_bounds(diagnostics, path, value, positive());
    else if (value != 0)
      diagnostics.report(path, shown(path) + " is not used by this collapse guard; leave it at 0");
  };
  check("contact-time", guard.contact_time, CollapseGuard::contact_time);
  check("reference-speed", guard.reference_speed, CollapseGuard::velocity_dependent);
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

void check(const Scene& scene, Diagnostics& diagnostics) {
  check_guard(std::get<EventDrivenOptions>(scene.method.options).guard, diagnostics);
  check_box(scene, diagnostics);
  if (scene.species.size() > most_species)
    diagnostics.report(item_path("species", most_species),
                       fmt::format("{} species; at most {} are allowed", scene.species.size(), most_species));
}

MethodFamily make_family() {
  using enum SurfaceKind;
  MethodFamily family;
  family.name = "event-driven";
  family.can.contacts = true;
  family.can.species = true;
  family.can.spins = true;
  family.can.wall_rules = {specular, bounce_back, random_tangential_sign, thermal};
  family.can.obstacles = true;
  family.can.event_trace = true;
  family.can.varying_number = true;
  family.can.outflows = true;
  family.presets = {{{"event-driven", "exact event-driven hard disks and spheres"}, EventDrivenOptions{}}};
  family.keys = {"collapse-guard", "contact-time", "reference-speed"};
  family.refused = {{{"contact-factor", "density", "offset", "random-offset", "pair-count"},
                     "is not used by the method 'event-driven', whose collisions are exact; remove it"},
                    {{"cells", "cell-size"}, "is chosen by the method 'event-driven' itself; remove it"}};
  family.read = read;
  family.write = write;
  family.check = check;
  return family;
}
}  // namespace

const MethodFamily& event_driven_family() {
  static const MethodFamily family = make_family();
  return family;
}

}  // namespace sandglass
