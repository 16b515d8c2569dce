#pragma once

#include "sim/base/exact_sum.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sandglass {

/// What a restart needs beside the particles, by name.
using Memory = std::map<std::string, std::vector<double>>;

/// What every method counts while it runs, for the observers that ask. Integers and exact sums: the order of the cells
/// cannot show.
struct Tally {
  std::uint64_t collisions = 0;
  std::uint64_t candidates = 0;  ///< pairs drawn
  std::uint64_t moves = 0;       ///< particle-moves
  /// Collisional virial: sum over collisions of J . (r_1 - r_2), J the momentum that particle 1 gains; for a method with
  /// offsets the sum of m v' . displacement over both partners.
  ExactSum transfer;
  std::vector<std::uint64_t>
      impact;  ///< collisions since time zero by |b| / d, Needs::impact_bins over [0, 1]
  /// Collisions since time zero of species a with species b at [a * species + b], a the first partner; empty: not counted.
  std::vector<std::uint64_t> by_species;
  /// What regions of other weights do to who crosses between them, see CloningSums; empty: not counted.
  std::vector<ExactSum> cloning;
  double deepest_overlap = 0;  ///< largest overlap at a collision, in diameters

  /// What was counted elsewhere in the same way.
  void add(const Tally& other);
  /// As at time zero.
  void clear();

  void save(Memory& memory) const;
  /// Throws std::out_of_range when the memory lacks a number.
  void load(const Memory& memory);
};

}  // namespace sandglass
