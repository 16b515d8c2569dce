#pragma once

#include "sim/method/event_driven/event_driven.hpp"
#include "sim/method/event_driven/policies.hpp"

namespace sandglass::event_driven {

/// The engine of a Choice. They are compiled by dimension and flight, in engine_<dimension>_<flight>.cpp.
template <class C>
std::unique_ptr<Simulator<C::D>> make_engine(const Parameters<C::D>& parameters, Agents<C::D> agents,
                                             const Streams& streams, EventSink<C::D>* trace);

}  // namespace sandglass::event_driven
