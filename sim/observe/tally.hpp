#pragma once

#include "sim/base/exact_sum.hpp"

#include <cstdint>

namespace sandglass {

/// What a method counts while it runs, for the observers that ask. Integers and exact sums: the order of the cells
/// cannot show.
struct Tally {
  std::uint64_t collisions = 0;
  std::uint64_t candidates = 0;    ///< pairs tried
  std::uint64_t bound_raised = 0;  ///< collisions after which the bound on relative speeds had to rise
  std::uint64_t moves = 0;         ///< particle-moves
  ExactSum transfer;  ///< sum over collisions of m v' . displacement: momentum carried by the offsets
};

}  // namespace sandglass
