#include "sim/base/packing.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/method/dsmc.hpp"
#include "sim/scene/text/bounds.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
const Words<ExcludedVolume>& excluded_volume_words() {
  static const Words<ExcludedVolume> words = {{"none", ExcludedVolume::none},
                                              {"cells", ExcludedVolume::cells}};
  return words;
}

const Words<Entry>& entry_words() {
  static const Words<Entry> words = {{"free", Entry::free}, {"falling", Entry::falling}};
  return words;
}

void check_entry(const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  const Curve& curve = dsmc.entry_curve;
  if (curve.at.empty() && curve.value.empty()) return;
  const std::string path = "method.entry-probability";
  if (!check_curve(curve, path, "fraction", "probability", diagnostics)) return;
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    check_bounds(diagnostics, item_path(path + ".probability", i), curve.value[i], between(0, 1));
}

/// Of the smallest cell to a whole one: displaced cells and those on a corner are down to half as wide at walls.
double smallest_cell(const Scene& scene, const std::vector<double>& cells) {
  const CellLattice lattice = std::get<DsmcOptions>(scene.method.options).lattice;
  double smallest = 1;
  for (std::size_t axis = 0; axis < cells.size(); ++axis)
    if (scene.domain.sides[axis][0] != Side::periodic &&
        (lattice == CellLattice::diagonal || (lattice == CellLattice::shifted && cells[axis] > 1)))
      smallest /= 2;
  return smallest;
}

/// Where the cells are given: room for one particle at least.
void check_room(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  for (const char* path : {"method", "domain", "species"})
    if (!diagnostics.clean(path)) return;
  const std::vector<double> along = cells_along(scene);
  if (along.empty()) return;
  double cells = dsmc.lattice == CellLattice::diagonal ? 2 : 1;
  for (const double number : along) cells *= number;
  const int dimension = scene.domain.dimension;
  const double densest = dsmc.densest_fraction.value_or(random_close_packing(dimension));
  const double one = scene.method.weight * particle_volume(scene.species.front(), dimension);
  const double room = densest * volume(scene.domain) / cells / one * smallest_cell(scene, along);
  if (room < 1)
    diagnostics.report(
        dsmc.cells.empty() ? "method.cell-size" : "method.cells",
        fmt::format("{} has room for {:.3g} simulated particles; widen the cells or lower "
                    "'method.weight', so that at least 1 fits in",
                    smallest_cell(scene, along) < 1 ? "the smallest cell at a wall" : "a cell", room));
}
}  // namespace

void read_excluded_volume(Table& table, DsmcOptions& dsmc) {
  table.read_word("excluded-volume", "excluded volume", dsmc.excluded_volume, excluded_volume_words());
  if (dsmc.excluded_volume == ExcludedVolume::none && table.clean("excluded-volume")) {
    for (const char* key : {"densest-fraction", "entry", "entry-probability", "offset-in-full-cells"})
      table.refuse(key, "is used with excluded-volume = \"cells\" only");
    dsmc.entry = Entry::free;
    dsmc.offset_in_full_cells = false;
    return;
  }
  table.read("densest-fraction", dsmc.densest_fraction);
  table.read_word("entry", "entry", dsmc.entry, entry_words());
  if (auto curve = table.table("entry-probability")) {
    curve->require("fraction", dsmc.entry_curve.at, "rising fractions, for example [0.5, 0.8]");
    curve->require("probability", dsmc.entry_curve.value, "of entering at each, for example [1.0, 0.0]");
    curve->finish();
    if (curve->clean() && dsmc.entry_curve.at.empty() && dsmc.entry_curve.value.empty())
      table.refuse("entry-probability", "is empty; give at least one point, or leave it out for the default");
  }
  table.read("offset-in-full-cells", dsmc.offset_in_full_cells);
}

void write_excluded_volume(Lines& lines, const DsmcOptions& dsmc) {
  lines.add("excluded-volume", word_of(excluded_volume_words(), dsmc.excluded_volume));
  if (dsmc.excluded_volume == ExcludedVolume::none) return;
  lines.add("densest-fraction", dsmc.densest_fraction);
  lines.add("entry", word_of(entry_words(), dsmc.entry));
  if (!dsmc.entry_curve.at.empty())
    lines.add_table("entry-probability", {{"fraction", write_value(dsmc.entry_curve.at)},
                                          {"probability", write_value(dsmc.entry_curve.value)}});
  lines.add("offset-in-full-cells", dsmc.offset_in_full_cells);
}

void check_excluded_volume(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (dsmc.excluded_volume == ExcludedVolume::none) return;
  const double close = close_packing(scene.domain.dimension);
  if (dsmc.densest_fraction &&
      check_bounds(diagnostics, "method.densest-fraction", *dsmc.densest_fraction, positive()) &&
      *dsmc.densest_fraction > close)
    diagnostics.report("method.densest-fraction",
                       fmt::format("'method.densest-fraction' is {}, above close packing ({})",
                                   *dsmc.densest_fraction, close));
  if (dsmc.entry == Entry::free && !dsmc.entry_curve.at.empty())
    diagnostics.report("method.entry-probability",
                       "'method.entry-probability' is used with entry = \"falling\" only");
  check_entry(dsmc, diagnostics);
  check_room(scene, dsmc, diagnostics);
}

}  // namespace sandglass
