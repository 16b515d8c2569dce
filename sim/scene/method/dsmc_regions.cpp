#include "sim/scene/method/dsmc.hpp"

#include <fmt/format.h>

namespace sandglass {

/// What counts the particles of several cells together would have to weigh each, and what displaces them would carry one into
/// a region of another weight in the middle of a collision.
void check_regions_of_cells(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (scene.regions.empty()) return;
  const auto allow = [&](bool allowed, const char* key, const char* words, const char* reason) {
    const std::string path = std::string("method.") + key;
    if (!allowed && diagnostics.clean(path))
      diagnostics.report(path, fmt::format("'{}' must be {} with a [[region]]: {}", path, words, reason));
  };
  allow(dsmc.contact_factor == ContactFactor::none, "contact-factor", "\"none\"",
        "the local density takes all particles for alike");
  allow(dsmc.offset == Offset::none, "offset", "\"none\"",
        "partners would be displaced into regions of another weight");
  allow(dsmc.pair_count != PairCount::expected, "pair-count", "\"counted\" or \"time-counter\"",
        "the local density takes all particles for alike");
  allow(dsmc.partners == Partners::cell, "partners", "\"cell\"",
        "partners in two regions stand for different numbers of real particles");
  allow(dsmc.excluded_volume == ExcludedVolume::none, "excluded-volume", "\"none\"",
        "a full cell takes all particles for alike");
  allow(dsmc.impact == ImpactDistribution::uniform, "impact", "\"uniform\"",
        "its coefficient follows the collisions of particles that are alike");
  allow(dsmc.lattice == CellLattice::fixed, "lattice", "\"fixed\"",
        "cells would be displaced over the borders of regions");
}

}  // namespace sandglass
