#pragma once

#include "sim/method/event_driven/gas.hpp"

namespace sandglass::event_driven {

/// The columns of the gas as numbers by name, for a checkpoint. Whole numbers below 2^53 keep every digit.
template <int D>
void save_gas(const Gas<D>& gas, Memory& memory);
template <int D>
void load_gas(const Memory& memory, Gas<D>& gas);

}  // namespace sandglass::event_driven
