#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/gas.hpp"
#include "sim/method/event_driven/progress.hpp"

namespace sandglass::event_driven {

/// The state of the engine as numbers by name, for a checkpoint. Whole numbers below 2^53 keep every digit.
template <int D>
Memory save_state(const Gas<D>& gas, const Agents<D>& agents, const Progress& progress);
/// Into a gas with as many particles and the same columns. Throws InputError for a damaged checkpoint.
template <int D>
void load_state(const Memory& memory, Gas<D>& gas, Agents<D>& agents, Progress& progress);

}  // namespace sandglass::event_driven
