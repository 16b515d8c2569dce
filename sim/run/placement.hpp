#pragma once

#include "sim/base/random.hpp"
#include "sim/method/simulator.hpp"
#include "sim/scene/scene.hpp"

#include <vector>

namespace sandglass {

/// Particles at rest where the scene wants them: random, on a regular lattice, or random without overlap (random
/// sequential addition). Throws InputError when no place is left.
template <int D>
std::vector<Phase<D>> place(const Scene& scene, std::uint64_t count, const Streams& streams);

}  // namespace sandglass
