#pragma once

#include "sim/base/random.hpp"
#include "sim/run/placement_room.hpp"

#include <vector>

namespace sandglass {

/// Uniform in the box, outside obstacles.
template <int D>
std::vector<Vector<D>> place_randomly(const Room<D>& room, std::uint64_t count, const StreamKey& key);

/// As a gas of the scene's temperature rests under its gravity: exp(-m g z / T) between the two walls, uniform along the
/// other axes, outside obstacles.
template <int D>
std::vector<Vector<D>> place_barometrically(const Scene& scene, const Room<D>& room, std::uint64_t count,
                                            const StreamKey& key);

}  // namespace sandglass
