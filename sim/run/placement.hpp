#pragma once

#include "sim/base/random.hpp"
#include "sim/method/simulator.hpp"
#include "sim/scene/scene.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// Particles at rest where the scene wants them: random, on a regular lattice (in layers: from the top down), or random
/// without overlap (random sequential addition). `species` has an entry a particle, or none when there is one species. The hard particles of an
/// event-driven scene overlap neither each other nor walls and obstacles; on a lattice, each has room for the largest.
/// Throws InputError when the placement cannot be had.
template <int D>
std::vector<Phase<D>> place(const Scene& scene, std::uint64_t count, const Streams& streams,
                            std::span<const std::uint8_t> species = {});

}  // namespace sandglass
