#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/method/planted_fault.hpp"

namespace sandglass::dsmc {

using FaultChange = void (*)(Parameters&, int dimension);

const std::vector<FaultEntry<FaultChange>>& planted_faults();

}  // namespace sandglass::dsmc
