#pragma once

#include "sim/method/plan.hpp"

#include <string>

namespace sandglass::program {

/// "74 bytes a particle, 7.51 MB", and what this machine has where that is less.
std::string memory_words(const Plan& plan);

/// Whether the particles of one replica alone take more than the machine's memory.
bool exceeds_memory(const Plan& plan);

}  // namespace sandglass::program
