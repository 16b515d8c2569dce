#include "sim/scene/method/dsmc.hpp"
#include "sim/scene/text/bounds.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
const Words<CellLattice>& lattice_words() {
  static const Words<CellLattice> words = {
      {"fixed", CellLattice::fixed}, {"shifted", CellLattice::shifted}, {"diagonal", CellLattice::diagonal}};
  return words;
}

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

void check_lattice(const DsmcOptions& dsmc, const Domain& domain, Diagnostics& diagnostics) {
  if (dsmc.lattice == CellLattice::diagonal && domain.dimension != 2 && diagnostics.clean("domain.dimension"))
    diagnostics.report(
        "method.lattice",
        "'method.lattice' is \"diagonal\", which is known in 2D only; use \"fixed\" or \"shifted\"");
}
}  // namespace

void read_cells(Table& table, DsmcOptions& dsmc) {
  table.read_word("lattice", "lattice", dsmc.lattice, lattice_words());
  table.read("cells", dsmc.cells);
  table.read("cell-size", dsmc.cell_size);
  if (table.has("cells")) table.refuse("cell-size", "is given beside 'cells'; give one of them");
}

void write_cells(Lines& lines, const DsmcOptions& dsmc) {
  lines.add("lattice", word_of(lattice_words(), dsmc.lattice));
  if (!dsmc.cells.empty()) lines.add("cells", dsmc.cells);
  lines.add("cell-size", dsmc.cell_size);
}

void check_cells(const DsmcOptions& dsmc, const Domain& domain, Diagnostics& diagnostics) {
  check_lattice(dsmc, domain, diagnostics);
  for (const char* path : {"domain.dimension", "domain.size", "method.cells", "method.cell-size"})
    if (!diagnostics.clean(path)) return;
  if (dsmc.cell_size && !dsmc.cells.empty())
    return diagnostics.report("method.cells", "'method' takes 'cells' or 'cell-size', not both");
  if (!dsmc.cell_size && dsmc.cells.empty()) return;
  const double total = dsmc.cell_size ? check_size(domain, *dsmc.cell_size, diagnostics)
                                      : check_numbers(dsmc.cells, domain.dimension, diagnostics) *
                                            (dsmc.lattice == CellLattice::diagonal ? 2 : 1);
  const std::string path = dsmc.cell_size ? "method.cell-size" : "method.cells";
  if (total > most_cells && diagnostics.clean(path))
    diagnostics.report(
        path, fmt::format("{} gives {:.3g} cells; at most {} are allowed", shown(path), total, most_cells));
}

}  // namespace sandglass
