#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/gas.hpp"
#include "sim/method/event_driven/progress.hpp"

namespace sandglass::event_driven {

/// The state of the engine as numbers by name, for a checkpoint. Whole numbers below 2^53 keep every digit.
template <int D>
Memory save_state(const Gas<D>& gas, const Agents<D>& agents, const Progress& progress);
/// Into a gas with as many particles and the same columns. Throws InputError for a damaged checkpoint.
template <int D>
void load_state(const Memory& memory, Gas<D>& gas, Agents<D>& agents, Progress& progress);

/// Throws InputError for numbers that no run leaves behind: they would lead beyond the end of a list, or back in time.
template <int D>
void require_sound(const Gas<D>& gas, const Cells<D>& cells, std::size_t agents, std::size_t species,
                   const Progress& progress);

}  // namespace sandglass::event_driven
