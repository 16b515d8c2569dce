#pragma once

#include "sim/method/simulator.hpp"
#include "sim/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace sandglass {

/// The species of every particle, as many of each as the scene wants, in the order of the scene; empty when there is one
/// only.
std::vector<std::uint8_t> ordered_species(const Scene& scene);
/// The same in random order.
std::vector<std::uint8_t> shuffled_species(const Scene& scene, const Streams& streams);

}  // namespace sandglass
