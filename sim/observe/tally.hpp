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
  /// Collisional virial: sum over collisions of J . (r_1 - r_2), J the momentum that particle 1 gains; for a method with
  /// offsets the sum of m v' . displacement over both partners.
  ExactSum transfer;
  std::vector<std::uint64_t>
      impact;                     ///< collisions since time zero by |b| / d, Needs::impact_bins over [0, 1]
  std::uint64_t crossings = 0;    ///< cell crossings of an event-driven method
  std::uint64_t predictions = 0;  ///< searches for the next collision of a particle
  std::uint64_t guarded = 0;      ///< collisions that a collapse guard made elastic
  double deepest_overlap = 0;     ///< largest overlap met at a collision, in diameters
};

}  // namespace sandglass
