#pragma once

#include "sim/method/plan.hpp"

#include <string>

namespace sandglass::program {

/// What particles and samples take, and what this machine has where that is less.
std::string memory_words(const Plan& plan);

/// Whether the particles of one replica and the samples of all take more than the machine's memory.
bool exceeds_memory(const Plan& plan);

}  // namespace sandglass::program
