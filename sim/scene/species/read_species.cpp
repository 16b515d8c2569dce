#include "sim/scene/read_sections.hpp"

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
}  // namespace

void read_species(Table& table, int dimension, bool given, bool boxed, Species& species) {
  table.read("name", species.name);
  if (!given) read_amount(table, dimension, boxed, species);
  for (const std::string& key : amounts)
    if (given) table.refuse(key, "cannot be used with positions = \"given\": it follows from [[particle]]");
  table.read("diameter", species.diameter);
  table.read("mass", species.mass);
  table.read("restitution", species.restitution);
  table.read("tangential-restitution", species.tangential_restitution);
  table.read("friction", species.friction);
  table.read("moment-of-inertia", species.inertia_factor);
  table.finish();
}

}  // namespace sandglass
