#pragma once

#include "sim/method/event_driven/engine_events.hpp"
#include "sim/method/event_driven/engine_exchange.hpp"
#include "sim/method/event_driven/engine_state.hpp"
#include "sim/method/event_driven/make_engine.hpp"

namespace sandglass::event_driven {

// For the files that compile engines.

template <class C>
std::unique_ptr<Simulator<C::D>> make_engine(const Parameters<C::D>& parameters, Agents<C::D> agents,
                                             const Streams& streams, EventSink<C::D>* trace) {
  return std::make_unique<Engine<C>>(parameters, std::move(agents), streams, trace);
}

}  // namespace sandglass::event_driven
