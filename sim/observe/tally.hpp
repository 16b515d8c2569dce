#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/exact_sum.hpp"

namespace sandglass {

/// What a method counts while it runs, for the observers that ask. Integers and exact sums: the order of the cells
/// cannot show.
struct Tally {
  std::uint64_t collisions = 0;
  std::uint64_t candidates = 0;     ///< pairs tried
  std::uint64_t bound_raised = 0;   ///< collisions after which the bound on relative speeds had to rise
  std::uint64_t moves = 0;          ///< particle-moves
  ExactSum transfer;                ///< sum over collisions of m v' . displacement: momentum carried by the offsets
};

/// A plane that counts the particles passing it.
struct Plane {
  int axis = 0;
  double position = 0;
  std::vector<double> velocities;   ///< normal velocity of each crossing since the last sample, in no fixed order
};

}  // namespace sandglass
