#include "sim/scene/method/mixing.hpp"

#include "sim/scene/method/family.hpp"
#include "sim/scene/text/bounds.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

const MixingOptions* repulsion_in(const Scene& scene) {
  return std::get_if<MixingOptions>(&scene.method.options);
}

namespace {
const std::string here = "with the method 'mixing', ";
constexpr std::size_t most_species = 255;  // a particle keeps its species in one byte
constexpr double most_exponent = 100;
constexpr double most_blocks = 1e6;

const MixingOptions& options_of(const Scene& scene) { return std::get<MixingOptions>(scene.method.options); }

void read(Table& table, MethodOptions& all) {
  MixingOptions& options = std::get<MixingOptions>(all);
  table.read("repulsion-coefficient", options.repulsion_coefficient);
  table.read("repulsion-exponent", options.repulsion_exponent);
  table.read("core-exponent", options.core_exponent);
  table.read("softening-length", options.softening_length);
  table.read("cutoff", options.cutoff);
  table.read("support-blocks", options.support_blocks);
  table.read("wall-speed-factor", options.wall_speed_factor);
  table.read("smallest-length", options.smallest_length);
}

void write(Lines& lines, const MethodOptions& all) {
  const MixingOptions& options = std::get<MixingOptions>(all);
  lines.add("repulsion-coefficient", options.repulsion_coefficient);
  lines.add("repulsion-exponent", options.repulsion_exponent);
  lines.add("core-exponent", options.core_exponent);
  lines.add("softening-length", options.softening_length);
  lines.add("cutoff", options.cutoff);
  if (!options.support_blocks.empty()) lines.add("support-blocks", options.support_blocks);
  lines.add("wall-speed-factor", options.wall_speed_factor);
  lines.add("smallest-length", options.smallest_length);
}

void check_numbers(const MixingOptions& options, Diagnostics& diagnostics) {
  const auto check = [&](const std::string& key, double value, const Bounds& bounds) {
    check_bounds(diagnostics, "method." + key, value, bounds);
  };
  check("repulsion-coefficient", options.repulsion_coefficient, at_least(0));
  check("repulsion-exponent", static_cast<double>(options.repulsion_exponent), between(0, most_exponent));
  check("core-exponent", static_cast<double>(options.core_exponent), between(0, most_exponent));
  check("softening-length", options.softening_length, at_least(0));
  if (options.cutoff) check("cutoff", *options.cutoff, positive());
  check("wall-speed-factor", options.wall_speed_factor, between(0, 1));
  check("smallest-length", options.smallest_length, at_least(0));
  if (options.wall_speed_factor == 0 && options.smallest_length == 0 && diagnostics.clean("method"))
    diagnostics.report("method.smallest-length",
                       "'method.smallest-length' must be above 0 where walls take all the speed: the "
                       "direction is a path over its length, and there is none");
}

/// Gravity acts downwards, along y: support is a matter of what lies below.
void check_gravity(const Scene& scene, Diagnostics& diagnostics) {
  if (!diagnostics.clean("forces") || scene.gravity.size() != 2) return;
  if (scene.gravity[0] != 0 || scene.gravity[1] > 0)
    diagnostics.report("forces.gravity", "'forces.gravity' must act downwards " + here +
                                             "whose particles support each other from below: [0, -980]");
}

void check_blocks(const Scene& scene, Diagnostics& diagnostics) {
  const std::string path = "method.support-blocks";
  const auto& blocks = options_of(scene).support_blocks;
  if (blocks.empty() || !diagnostics.clean(path)) return;
  if (!check_length(diagnostics, path, blocks.size(), 2)) return;
  check_bounds(diagnostics, item_path(path, 0), static_cast<double>(blocks[0]), between(1, most_blocks));
  check_bounds(diagnostics, item_path(path, 1), static_cast<double>(blocks[1]), between(2, most_blocks));
  if (scene.gravity.empty() || (scene.gravity.size() == 2 && scene.gravity[1] == 0))
    diagnostics.report(path, shown(path) +
                                 " reduces gravity, and there is none: give 'forces.gravity', or "
                                 "remove it");
}

void check_walls(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.domain.dimension != 2 && diagnostics.clean("domain.dimension"))
    diagnostics.report("domain.dimension",
                       "'domain.dimension' must be 2 " + here + "which knows two dimensions only");
  if (!diagnostics.clean("domain")) return;
  for (std::size_t axis = 0; axis < scene.domain.sides.size(); ++axis)
    if (scene.domain.sides[axis] != std::array{Side::specular, Side::specular}) {
      const std::string path = "domain.sides." + axis_words()[axis].first;
      diagnostics.report(path,
                         shown(path) + " must be \"specular\" " + here + "whose box has walls on all sides");
    }
}

void check_kinds(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.species.size() > most_species)
    diagnostics.report(item_path("species", most_species),
                       fmt::format("{} species; at most {} are allowed", scene.species.size(), most_species));
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    const Species& species = scene.species[i];
    const auto refuse = [&](bool wrong, const std::string& key, const std::string& reason) {
      const std::string path = item_path("species", i) + '.' + key;
      if (wrong && diagnostics.clean(path)) diagnostics.report(path, shown(path) + ' ' + reason);
    };
    refuse(species.diameter != scene.species.front().diameter, "diameter",
           "must be the same for all species " + here + "whose repulsion knows one diameter");
    refuse(species.restitution != 1, "restitution",
           "is not used by the method 'mixing', whose particles do not collide; remove it");
    refuse(species.friction.has_value(), "friction", "is not used by the method 'mixing'; remove it");
    refuse(species.inertia_factor.has_value(), "moment-of-inertia",
           "is not used by the method 'mixing'; remove it");
  }
}

/// At distance zero an unsoftened repulsion has neither size nor direction.
void check_coincidence(const Scene& scene, Diagnostics& diagnostics) {
  if (options_of(scene).softening_length > 0 || !diagnostics.clean("particle")) return;
  std::vector<std::pair<std::vector<double>, std::size_t>> places;
  for (std::size_t i = 0; i < scene.given.size(); ++i) places.emplace_back(scene.given[i].position, i);
  std::ranges::sort(places);
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i].first == places[i - 1].first)
      diagnostics.report(item_path("particle", places[i].second) + ".position",
                         fmt::format("particles {} and {} (counted from 1) are at the same place, where the "
                                     "repulsion is infinite: move one of them or give "
                                     "'method.softening-length' above 0",
                                     places[i - 1].second + 1, places[i].second + 1));
}

void check_observers(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.observe.size(); ++i) {
    const std::string &what = scene.observe[i].what, path = item_path("observe", i) + ".what";
    if ((what == "pressure" || what == "wall-force" || what == "collisions") && diagnostics.clean(path))
      diagnostics.report(path, "the observer '" + what +
                                   "' counts impulses or collisions, which the method "
                                   "'mixing' does not; remove it");
  }
}

void check(const Scene& scene, Diagnostics& diagnostics) {
  check_numbers(options_of(scene), diagnostics);
  check_walls(scene, diagnostics);
  check_gravity(scene, diagnostics);
  check_blocks(scene, diagnostics);
  check_kinds(scene, diagnostics);
  check_coincidence(scene, diagnostics);
  check_observers(scene, diagnostics);
}

MethodFamily make_family() {
  MethodFamily family;
  family.name = "mixing";
  family.can.collisions = false;
  family.can.species = true;
  family.presets = {{{"mixing", "two fluids as particles that repel and support each other (Greenspan 1972)"},
                     MixingOptions{}}};
  family.keys = {
      "repulsion-coefficient", "repulsion-exponent", "core-exponent",  "softening-length", "cutoff",
      "support-blocks",        "wall-speed-factor",  "smallest-length"};
  family.read = read;
  family.write = write;
  family.check = check;
  return family;
}
}  // namespace

const MethodFamily& mixing_family() {
  static const MethodFamily family = make_family();
  return family;
}

}  // namespace sandglass
