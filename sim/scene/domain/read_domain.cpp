#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

namespace sandglass {

namespace {
void read_sides(Table& table, Domain& domain) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string& name = axis_words()[axis].first;
    if (axis < domain.sides.size())
      table.read_pair(name, "side", domain.sides[axis], side_words());
    else
      table.refuse(name, "cannot be: a domain of 2 dimensions has the axes x and y");
  }
  table.finish();
}
}  // namespace

void read_domain(Table& table, Domain& domain, std::vector<double>& proportions) {
  table.require("dimension", domain.dimension, "2 or 3");
  table.read("size", domain.size);
  if (table.has("size")) {
    table.refuse("proportions", "is given beside 'size', which says it all; remove it");
  } else {
    proportions.assign(domain.dimension == 2 ? 2 : 3, 1.0);
    table.read("proportions", proportions);
  }
  domain.sides.assign(domain.dimension == 2 ? 2 : 3, {Side::periodic, Side::periodic});
  if (std::optional<Table> sides = table.table("sides")) read_sides(*sides, domain);
  table.finish();
}

}  // namespace sandglass
