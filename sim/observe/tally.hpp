#pragma once

#include "sim/base/exact_sum.hpp"

#include <cstdint>
#include <vector>

namespace sandglass {

/// What a method counts while it runs, for the observers that ask. Integers and exact sums: the order of the cells
/// cannot show.
struct Tally {
  std::uint64_t collisions = 0;
  std::uint64_t candidates = 0;    ///< pairs tried
  std::uint64_t bound_raised = 0;  ///< collisions after which the bound on relative speeds had to rise
  std::uint64_t moves = 0;         ///< particle-moves
  ExactSum
      transfer;  ///< sum over collisions of the kick times the distance it jumps, m v' . r: collisional virial
  std::vector<std::uint64_t>
      impact;  ///< collisions by |b| / d, since the last call of the observer that asked for bins
  std::uint64_t crossings = 0;    ///< cell crossings of an event-driven method
  std::uint64_t predictions = 0;  ///< searches for the next collision of a particle
  std::uint64_t guarded = 0;      ///< collisions that a collapse guard made elastic
  double deepest_overlap = 0;     ///< largest overlap met at a collision, in diameters
};

}  // namespace sandglass
