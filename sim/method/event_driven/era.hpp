#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/gas.hpp"
#include "sim/method/event_driven/progress.hpp"

namespace sandglass::event_driven {

/// The era that begins at time zero. One without an end when nothing will ever happen.
template <int D>
Era plan_era(const Gas<D>& gas);

/// Places of the particles in the order of their cells.
template <int D>
std::vector<std::uint32_t> order_by_cell(const Gas<D>& gas, const Cells<D>& cells);

/// Root mean square speed.
template <int D>
double speed_scale(const Gas<D>& gas);

}  // namespace sandglass::event_driven
