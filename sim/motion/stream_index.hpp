#pragma once

#include <cstdint>

namespace sandglass::motion {

/// Names the random stream of a particle within a step by its cell before the step and its place there: neither the order
/// of work nor a decomposition shows.
inline std::uint64_t stream_index(std::uint32_t cell, std::uint32_t place) {
  return std::uint64_t{cell} << 32 | place;
}

}  // namespace sandglass::motion
