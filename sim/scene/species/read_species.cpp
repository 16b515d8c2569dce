#include "sim/scene/read_sections.hpp"
#include "sim/scene/species/diameters.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
void read_fraction(Table& table, int dimension, Species& species) {
  if (dimension != 2 && dimension != 3) {
    table.read("area-fraction", species.fraction);
    table.read("volume-fraction", species.fraction);
    return;
  }
  const std::string right = dimension == 2 ? "area-fraction" : "volume-fraction";
  const std::string wrong = dimension == 2 ? "volume-fraction" : "area-fraction";
  table.read(right, species.fraction);
  table.refuse(wrong, "cannot be used in " + std::to_string(dimension) + " dimensions: use '" + right + "'");
}

const std::vector<std::string> amounts = {"count", "area-fraction", "volume-fraction", "number-density"};

/// Beside 'count' a fraction is one amount too many, unless the size of the domain is to follow from the two.
void keep_one_amount(Table& table, bool boxed) {
  std::vector<std::string> given;
  for (const std::string& key : amounts)
    if (table.has(key)) given.push_back(key);
  if (!boxed && given.size() == 2 && given[0] == "count" && given[1].ends_with("fraction")) return;
  const std::string choice =
      "give exactly one of 'count', 'area-fraction' (2D), 'volume-fraction' (3D) or 'number-density'";
  if (given.empty()) table.report_missing("count", choice);
  for (std::size_t i = 1; i < given.size(); ++i)
    table.refuse(given[i], "is given beside '" + given[0] + "'; " + choice);
}

void read_amount(Table& table, int dimension, bool boxed, Species& species) {
  table.read("count", species.count);
  read_fraction(table, dimension, species);
  table.read("number-density", species.number_density);
  keep_one_amount(table, boxed);
}

/// What a class has of all that are counted from the first on: whole numbers whose sum is that of all.
std::uint64_t part_of(std::uint64_t count, double before, double share) {
  const auto up_to = [count](double part) { return std::floor(static_cast<double>(count) * part + 0.5); };
  return static_cast<std::uint64_t>(up_to(before + share) - up_to(before));
}

/// A species for each of the diameters, of one material: the mass is that of a particle of the mean diameter.
void spread(const Species& species, const Diameters& diameters, int dimension, std::vector<Species>& all) {
  double volume = 0, before = 0;
  const auto volume_of = [dimension](double diameter) { return std::pow(diameter, dimension); };
  for (std::size_t i = 0; i < diameters.values.size(); ++i)
    volume += diameters.shares[i] * volume_of(diameters.values[i]);
  for (std::size_t i = 0; i < diameters.values.size(); ++i) {
    const double share = diameters.shares[i], diameter = diameters.values[i];
    Species part = species;
    part.name = fmt::format("{}-{}", species.name, i + 1);
    part.diameter = diameter;
    part.mass *= volume_of(diameter / diameters.mean());
    if (part.count) part.count = part_of(*species.count, before, share);
    if (part.fraction) *part.fraction *= share * volume_of(diameter) / volume;
    if (part.number_density) *part.number_density *= share;
    before += share;
    all.push_back(part);
  }
}
}  // namespace

void read_species(Table& table, int dimension, bool given, bool boxed, std::vector<Species>& all) {
  Species species;
  table.read("name", species.name);
  if (!given) read_amount(table, dimension, boxed, species);
  for (const std::string& key : amounts)
    if (given) table.refuse(key, "cannot be used with positions = \"given\": it follows from [[particle]]");
  std::optional<Diameters> diameters;
  if (table.is("diameter", Node::Kind::table))
    diameters = read_diameters(table);
  else
    table.read("diameter", species.diameter);
  if (diameters && (given || !boxed))
    table.refuse("diameter",
                 given
                     ? "cannot be a distribution with positions = \"given\": each particle names its species"
                     : "cannot be a distribution without 'domain.size'");
  table.read("mass", species.mass);
  table.read("restitution", species.restitution);
  table.read("tangential-restitution", species.tangential_restitution);
  table.read("friction", species.friction);
  table.read("moment-of-inertia", species.inertia_factor);
  table.finish();
  if (diameters && dimension > 0)
    spread(species, *diameters, dimension, all);
  else
    all.push_back(species);
}

}  // namespace sandglass
