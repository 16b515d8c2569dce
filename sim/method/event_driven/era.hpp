#pragma once

#include "sim/method/event_driven/cells.hpp"
#include "sim/method/event_driven/gas.hpp"

namespace sandglass::event_driven {

/// The row of buckets of one era: so long that a particle has about a dozen events in it, so fine that a bucket holds
/// few. Both follow from the events to come, and so go along as a gas cools.
struct Era {
  double width = HUGE_VAL;
  std::size_t buckets = 1;
  /// A cluster near collapse has most of the events to itself: the era ends after these, or what its events have left
  /// behind in the calendar would grow without bound.
  std::uint64_t most_events = std::uint64_t{1} << 53;
  double end() const { return width * static_cast<double>(buckets); }
};

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
