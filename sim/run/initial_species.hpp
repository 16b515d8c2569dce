#pragma once

#include "sim/method/simulator.hpp"
#include "sim/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace sandglass {

/// The species of every particle, as many of each as the scene wants, in random order; empty when there is one only.
std::vector<std::uint8_t> shuffled_species(const Scene& scene, const Streams& streams);

}  // namespace sandglass
