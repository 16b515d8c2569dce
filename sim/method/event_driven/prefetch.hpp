#pragma once

#include "sim/method/event_driven/exit.hpp"
#include "sim/method/event_driven/gas.hpp"
#include "sim/space/event_calendar.hpp"

namespace sandglass::event_driven {

/// Brings the cache lines that coming events will read, in the order in which they can be known: the particle; its partner
/// and the cells around; who is in those. It changes nothing: in a gas beyond the cache an event would wait for about
/// twenty lines one after the other.
template <int D>
class Prefetch {
 public:
  /// Pays from about this size on.
  static bool pays(std::size_t particles) {
    return particles * (sizeof(Particle<D>) + sizeof(Next)) > (2u << 20);
  }

  void operator()(const Gas<D>& gas, const Cells<D>& cells, const EventCalendar& calendar) {
    if (const auto* entry = calendar.peek(20)) fetch_particle(gas, entry->owner);
    if (const Next* next = valid(gas, calendar.peek(14))) {
      cells.prefetch_around(next->cell);
      if (next->partner < kFirstAgent) fetch_particle(gas, next->partner);
    }
    if (const auto* entry = calendar.peek(8); const Next* next = valid(gas, entry)) {
      if (next->time < next->contact) return fetch_ahead(gas, cells, *next);
      fetch_around(gas, cells, next->cell);
      if (next->partner < kFirstAgent) cells.prefetch_around(gas.next[next->partner].cell);
    }
    if (const Next* next = valid(gas, calendar.peek(4)); next != nullptr && next->time == next->contact)
      if (next->partner < kFirstAgent) fetch_around(gas, cells, gas.next[next->partner].cell);
  }

 private:
  static const Next* valid(const Gas<D>& gas, const EventCalendar::Entry* entry) {
    if (entry == nullptr) return nullptr;
    const Next& next = gas.next[entry->owner];
    return next.time == entry->time ? &next : nullptr;
  }
  static void fetch_particle(const Gas<D>& gas, std::uint32_t particle) {
    __builtin_prefetch(&gas.next[particle]);
    __builtin_prefetch(&gas.particles[particle]);
  }
  void fetch_found(const Gas<D>& gas) {
    for (std::uint32_t k = 0; k < near_.size(); ++k) __builtin_prefetch(&gas.particles[near_[k]]);
  }
  void fetch_around(const Gas<D>& gas, const Cells<D>& cells, std::uint32_t cell) {
    cells.heads_around(cell, near_);
    fetch_found(gas);
  }
  void fetch_ahead(const Gas<D>& gas, const Cells<D>& cells, const Next& next) {
    const int axis = Exit::axis_of(next.exit);
    const bool up = Exit::up_of(next.exit);
    double shift = 0;
    cells.heads_ahead(cells.step(next.cell, axis, up, shift), axis, up, near_);
    fetch_found(gas);
  }

  Candidates near_;
};

}  // namespace sandglass::event_driven
