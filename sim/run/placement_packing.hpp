#pragma once

#include "sim/base/random.hpp"
#include "sim/run/placement_room.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// Random sequential addition of disks or spheres, the largest first: a point is kept if the particle there overlaps
/// no earlier one, no wall and no obstacle. Particle i draws from the stream of index i. Throws InputError when no
/// place is found.
template <int D>
std::vector<Vector<D>> pack_randomly(const Room<D>& room, std::span<const double> radii,
                                     const StreamKey& key);

}  // namespace sandglass
