#include "sim/scene/bounds.hpp"
#include "sim/scene/rules.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_cells = 2147483647;  // cell numbers are 32 bits wide

/// Reports unusable numbers of cells; returns their product.
double check_numbers(const Scene& scene, Diagnostics& diagnostics) {
  const std::vector<std::uint64_t>& cells = scene.method.cells;
  check_length(diagnostics, "method.cells", cells.size(), scene.domain.dimension);
  double total = 1;
  for (std::size_t axis = 0; axis < cells.size(); ++axis) {
    const double number = static_cast<double>(cells[axis]);
    check_bounds(diagnostics, item_path("method.cells", axis), number, between(1, most_cells));
    total *= number;
  }
  return total;
}

/// Reports cells wider than the domain; returns the number of cells of that edge.
double check_size(const Domain& domain, double edge, Diagnostics& diagnostics) {
  const double narrowest = *std::min_element(domain.size.begin(), domain.size.end());
  if (edge > narrowest)
    diagnostics.report("method.cell-size",
                       fmt::format("'method.cell-size' is {}, wider than the domain ({})", edge, narrowest));
  return volume(domain) / std::pow(edge, domain.dimension);
}
}  // namespace

void check_cells(const Scene& scene, Diagnostics& diagnostics) {
  const Method& method = scene.method;
  if (method.cell_size && !method.cells.empty())
    return diagnostics.report("method.cells", "'method' takes 'cells' or 'cell-size', not both");
  if (!method.cell_size && method.cells.empty()) return;
  const double total = method.cell_size ? check_size(scene.domain, *method.cell_size, diagnostics)
                                        : check_numbers(scene, diagnostics);
  const std::string path = method.cell_size ? "method.cell-size" : "method.cells";
  if (total > most_cells && diagnostics.clean(path))
    diagnostics.report(
        path, fmt::format("{} gives {:.3g} cells; at most {} are allowed", shown(path), total, most_cells));
}

}  // namespace sandglass
