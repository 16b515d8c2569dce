#include "sim/scene/bounds.hpp"
#include "sim/scene/catalogue.hpp"
#include "sim/scene/rules.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_particles = 1e11;  // 10 TB at 100 bytes a particle

void check_name(Diagnostics& diagnostics, const std::string& path, const std::string& name) {
  const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  if (name.empty() || name.find_first_not_of(allowed) != std::string::npos)
    diagnostics.report(path, shown(path) + " must be a word of letters, digits, '-' and '_'");
}

void check_amount(Diagnostics& diagnostics, const std::string& path, const Species& species, int dimension) {
  const int given =
      species.count.has_value() + species.fraction.has_value() + species.number_density.has_value();
  if (given != 1 && diagnostics.clean(path))
    diagnostics.report(path, shown(path) + " needs exactly one of 'count', '" + fraction_key(dimension) +
                                 "' or 'number-density'");
  const std::string fraction_path = join_path(path, fraction_key(dimension));
  if (species.fraction) check_bounds(diagnostics, fraction_path, *species.fraction, positive());
  if (species.number_density)
    check_bounds(diagnostics, join_path(path, "number-density"), *species.number_density, positive());
}

/// Where the user said how many particles there are.
std::string amount_path(const Scene& scene) {
  const Species& species = scene.species.front();
  const std::string key = species.count      ? "count"
                          : species.fraction ? fraction_key(scene.domain.dimension)
                                             : "number-density";
  return "species[0]." + key;
}

void check_count(const Scene& scene, Diagnostics& diagnostics) {
  const double count = static_cast<double>(particle_count(scene, scene.species.front()));
  const std::string path = amount_path(scene);
  const std::string gives = fmt::format("{} gives {} particle{}", shown(path), count, count == 1 ? "" : "s");
  if (count < 2) diagnostics.report(path, gives + "; at least 2 are needed, since fewer cannot collide");
  if (count > most_particles)
    diagnostics.report(path, fmt::format("{}; at most {} are allowed", gives, most_particles));
}

/// Densest packings: disks pi/(2 sqrt 3), spheres pi/(3 sqrt 2). Random close packing: 0.82 and 0.64 (Mueller
/// 2001).
void check_fraction(const Scene& scene, Diagnostics& diagnostics) {
  const bool flat = scene.domain.dimension == 2;
  const double close = flat ? 0.9069 : 0.7405;
  const double random_close = flat ? 0.82 : 0.64;
  const double value = fraction(scene, scene.species.front());
  const std::string path = amount_path(scene);
  const std::string gives =
      fmt::format("{} gives the {} fraction {:.4g}", shown(path), flat ? "area" : "volume", value);
  if (value >= close)
    diagnostics.report(path, fmt::format("{}, at or above close packing ({}); use fewer or smaller particles",
                                         gives, close));
  else if (value >= random_close && scene.method.contact_factor == ContactFactor::local)
    diagnostics.report(
        path, fmt::format("{}, at or above random close packing ({}), where the contact value of the "
                          "local density does not hold; use fewer or smaller particles",
                          gives, random_close));
}
}  // namespace

void check_species(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.species.empty() && diagnostics.clean("species"))
    diagnostics.report("species", "missing 'species': describe the particles in a table headed [[species]]");
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    const Species& species = scene.species[i];
    const std::string path = item_path("species", i);
    check_name(diagnostics, path + ".name", species.name);
    check_amount(diagnostics, path, species, scene.domain.dimension);
    check_bounds(diagnostics, path + ".diameter", species.diameter, positive());
    check_bounds(diagnostics, path + ".mass", species.mass, positive());
    check_bounds(diagnostics, path + ".restitution", species.restitution, between(0, 1));
  }
  if (scene.species.size() > 1)
    diagnostics.report("species[1]",
                       "more than one species; every method of this version takes one: remove this table");
}

void check_packing(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.method.preset == reservoir_preset) return;
  check_count(scene, diagnostics);
  check_fraction(scene, diagnostics);
}

}  // namespace sandglass
