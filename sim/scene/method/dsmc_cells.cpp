#include "sim/scene/method/dsmc.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double most_cells = 2147483647;  // cell numbers are 32 bits wide

/// Reports unusable numbers of cells; returns their product.
double check_numbers(const std::vector<std::uint64_t>& cells, int dimension, Diagnostics& diagnostics) {
  check_length(diagnostics, "method.cells", cells.size(), dimension);
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

void check_cells(const DsmcOptions& dsmc, const Domain& domain, Diagnostics& diagnostics) {
  for (const char* path : {"domain.dimension", "domain.size", "method.cells", "method.cell-size"})
    if (!diagnostics.clean(path)) return;
  if (dsmc.cell_size && !dsmc.cells.empty())
    return diagnostics.report("method.cells", "'method' takes 'cells' or 'cell-size', not both");
  if (!dsmc.cell_size && dsmc.cells.empty()) return;
  const double total = dsmc.cell_size ? check_size(domain, *dsmc.cell_size, diagnostics)
                                      : check_numbers(dsmc.cells, domain.dimension, diagnostics);
  const std::string path = dsmc.cell_size ? "method.cell-size" : "method.cells";
  if (total > most_cells && diagnostics.clean(path))
    diagnostics.report(
        path, fmt::format("{} gives {:.3g} cells; at most {} are allowed", shown(path), total, most_cells));
}

}  // namespace sandglass
