#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/method/dsmc.hpp"

#include <fmt/format.h>

namespace sandglass {

const Words<Partners>& partners_words() {
  static const Words<Partners> words = {{"cell", Partners::cell}, {"contact", Partners::contact}};
  return words;
}

namespace {
void check_choices(const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  const auto allow = [&](bool allowed, const char* key, const char* word, const char* reason) {
    if (allowed) return;
    const std::string path = std::string("method.") + key;
    diagnostics.report(
        path, fmt::format("'{}' must be \"{}\" with partners = \"contact\": {}", path, word, reason));
  };
  allow(dsmc.offset == Offset::none, "offset", "none",
        "partners stand a diameter apart, and an offset would carry their momentum twice");
  allow(dsmc.pair_count == PairCount::counted, "pair-count", "counted",
        "candidates are particles with a direction, not pairs of a cell");
  allow(dsmc.excluded_volume == ExcludedVolume::none, "excluded-volume", "none",
        "full cells would collide as a whole and through their particles too");
  allow(dsmc.impact == ImpactDistribution::uniform, "impact", "uniform",
        "the line of centres is drawn, and no impact parameter");
  allow(dsmc.lattice == CellLattice::fixed, "lattice", "fixed",
        "partners are looked for in the cells around, which must stay in place");
}

/// Partners stand in the cells around if a cell is a diameter wide.
void check_width(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  for (const char* path : {"method", "domain", "species"})
    if (!diagnostics.clean(path)) return;
  const double least = least_cell_edge(scene);
  const std::vector<double> cells = cells_along(scene);
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    const double size = scene.domain.size[axis];
    if (size < least)
      return diagnostics.report(
          "domain.size",
          fmt::format("'domain.size' has an edge of {}; with partners = \"contact\" each must be at "
                      "least a diameter ({})",
                      size, least));
    if (!dsmc.cells.empty() && size < least * cells[axis])
      return diagnostics.report(
          "method.cells",
          fmt::format(
              "'method.cells' gives cells of {:.4g} along axis {}; with partners = \"contact\" they must be "
              "at least a diameter ({}) wide: at most {} here",
              size / cells[axis], axis, least, cells_of_edge(scene, least)[axis]));
  }
  if (dsmc.cell_size && *dsmc.cell_size < least)
    diagnostics.report("method.cell-size",
                       fmt::format("'method.cell-size' is {}; with partners = \"contact\" it must "
                                   "be at least a diameter ({})",
                                   *dsmc.cell_size, least));
}
}  // namespace

void check_partners(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (dsmc.partners == Partners::cell) return;
  check_choices(dsmc, diagnostics);
  check_width(scene, dsmc, diagnostics);
}

}  // namespace sandglass
