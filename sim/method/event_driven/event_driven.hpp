#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/method/simulator.hpp"
#include "sim/observe/event.hpp"

#include <memory>

namespace sandglass::event_driven {

/// Event-driven hard disks or spheres, compiled for what the scene needs. `trace`, if any, takes every event and must
/// outlive the simulator.
template <int D>
std::unique_ptr<Simulator<D>> make_event_driven(const Parameters<D>& parameters, Agents<D> agents,
                                                const Streams& streams, EventSink<D>* trace = nullptr);

}  // namespace sandglass::event_driven
