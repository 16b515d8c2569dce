#include "sim/base/packing.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_particles = 1e11;  // 10 TB at 100 bytes a particle

void check_name(Diagnostics& diagnostics, const std::string& path, const std::string& name) {
  const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  if (name.empty() || name.find_first_not_of(allowed) != std::string::npos)
    diagnostics.report(path, shown(path) + " must be a word of letters, digits, '-' and '_'");
}

/// `wanted`: 1, or 0 where the particles are given one by one.
void check_amount(Diagnostics& diagnostics, const std::string& path, const Species& species, int dimension,
                  int wanted) {
  const int given =
      species.count.has_value() + species.fraction.has_value() + species.number_density.has_value();
  const std::string keys = "'count', '" + fraction_key(dimension) + "' or 'number-density'";
  if (given != wanted && diagnostics.clean(path))
    diagnostics.report(path, shown(path) + (wanted == 1 ? " needs exactly one of " + keys
                                                        : " takes none of " + keys + " beside [[particle]]"));
  const std::string fraction_path = join_path(path, fraction_key(dimension));
  if (species.fraction) check_bounds(diagnostics, fraction_path, *species.fraction, positive());
  if (species.number_density)
    check_bounds(diagnostics, join_path(path, "number-density"), *species.number_density, positive());
}

/// Where the user said how many particles of a species there are.
std::string amount_path(const Scene& scene, std::size_t index) {
  if (!scene.given.empty()) return "particle";
  const Species& species = scene.species[index];
  const std::string key = species.count      ? "count"
                          : species.fraction ? fraction_key(scene.domain.dimension)
                                             : "number-density";
  return item_path("species", index) + '.' + key;
}

std::string gives(const std::string& path, std::uint64_t count) {
  return fmt::format("{} gives {} particle{}", shown(path), static_cast<double>(count),
                     count == 1 ? "" : "s");
}

/// A single hard particle still hits walls, and one that collides with none needs no other.
bool may_be_alone(const Scene& scene) {
  const auto walled = [](const auto& sides) { return sides[0] != Side::periodic; };
  if (!capabilities(scene).collisions) return true;
  return capabilities(scene).contacts &&
         (!scene.obstacles.empty() ||
          std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(), walled));
}

void check_count(const Scene& scene, Diagnostics& diagnostics) {
  const bool comes_in = !scene.sources.empty() || !scene.inflows.empty();
  const std::string path = amount_path(scene, 0);
  const std::uint64_t total = particle_count(scene);
  const bool alone = may_be_alone(scene);
  if (scene.species.size() == 1 || !scene.given.empty()) {
    if (total < 2 && !(alone && total == 1) && !(total == 0 && comes_in))
      diagnostics.report(path, gives(path, total) + (alone ? "; at least 1 is needed"
                                                           : "; at least 2 are needed, since fewer cannot "
                                                             "collide"));
  } else {
    for (std::size_t i = 0; i < scene.species.size(); ++i) {
      const std::string own = amount_path(scene, i);
      if (particle_count(scene, scene.species[i]) == 0 && scene.inflows.empty())
        diagnostics.report(own, gives(own, 0) + "; each species needs at least 1");
    }
  }
  if (static_cast<double>(total) > most_particles)
    diagnostics.report(
        path, fmt::format("{}{}; at most {} are allowed", gives(path, total),
                          scene.species.size() > 1 ? " with the other species" : "", most_particles));
}

void check_fraction(const Scene& scene, Diagnostics& diagnostics) {
  const bool flat = scene.domain.dimension == 2;
  const double close = close_packing(scene.domain.dimension);
  const double random_close = random_close_packing(scene.domain.dimension);
  const double value = fraction(scene);
  const std::string path = amount_path(scene, 0);
  const std::string density =
      fmt::format("{} gives the {} fraction {:.4g}{}", shown(path), flat ? "area" : "volume", value,
                  scene.species.size() > 1 ? " of all species" : "");
  if (value >= close)
    diagnostics.report(path, fmt::format("{}, at or above close packing ({}); use fewer or smaller particles",
                                         density, close));
  else if (value >= random_close && has_contact_factor(scene) && !has_full_cells(scene))
    diagnostics.report(
        path, fmt::format("{}, at or above random close packing ({}), where the contact value of the "
                          "local density does not hold; use fewer or smaller particles",
                          density, random_close));
}

void check_values(const Species& species, const std::string& path, Diagnostics& diagnostics) {
  check_name(diagnostics, path + ".name", species.name);
  check_bounds(diagnostics, path + ".diameter", species.diameter, moderate());
  check_bounds(diagnostics, path + ".mass", species.mass, moderate());
  check_bounds(diagnostics, path + ".restitution", species.restitution, between(0, 1));
  check_rough(species.tangential_restitution, species.friction, path, diagnostics);
  if (!species.inertia_factor) return;
  const std::string inertia = path + ".moment-of-inertia";
  if (check_bounds(diagnostics, inertia, *species.inertia_factor, between(0, 1)) &&
      *species.inertia_factor == 0)
    diagnostics.report(inertia, shown(inertia) + " is 0; allowed: above 0, to 1");
}

void check_names(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < scene.species.size(); ++i) {
    const std::string& name = scene.species[i].name;
    const auto same = [&name](const Species& other) { return other.name == name; };
    const auto end = scene.species.begin() + static_cast<std::ptrdiff_t>(i);
    const std::string path = item_path("species", i);
    if (std::any_of(scene.species.begin(), end, same) && diagnostics.clean(path))
      diagnostics.report(path, fmt::format("two species are called '{}'; give each its own 'name'", name));
  }
}
}  // namespace

void check_species(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.species.empty() && diagnostics.clean("species"))
    diagnostics.report("species", "missing 'species': describe the particles in a table headed [[species]]");
  const bool listed = !scene.given.empty() || !diagnostics.clean("particle");
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    const std::string path = item_path("species", i);
    if (diagnostics.clean("particle") || !scene.given.empty())
      check_amount(diagnostics, path, scene.species[i], scene.domain.dimension, listed ? 0 : 1);
    check_values(scene.species[i], path, diagnostics);
  }
  check_names(scene, diagnostics);
}

void check_packing(const Scene& scene, Diagnostics& diagnostics) {
  if (!capabilities(scene).particles) return;
  check_count(scene, diagnostics);
  if (diagnostics.clean("species")) check_fraction(scene, diagnostics);
}

}  // namespace sandglass
