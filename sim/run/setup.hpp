#pragma once

#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/event_driven/event_driven.hpp"
#include "sim/observe/observer.hpp"
#include "sim/run/run.hpp"

#include <memory>
#include <vector>

namespace sandglass {

/// What the scene decides before anything runs: the cells, what the method is told and who observes.
template <int D>
struct Setup {
  Grid<D> grid;
  dsmc::Parameters parameters;
  motion::MotionParameters<D> motion;
  event_driven::Parameters<D> hard;  ///< of the event-driven method
  std::vector<ObserverSpec> observers;
  std::uint64_t particles;
};

/// Throws InputError for a combination that the method cannot do.
template <int D>
Setup<D> set_up(const Scene& scene, const Mutation& mutation);

bool is_reservoir(const Scene& scene);

/// sqrt(T/m) of the initial state.
double thermal_speed(const Scene& scene);

/// The method of the scene, ready to take particles. `planes` and `trace` must outlive it; without a trace, null.
template <int D>
std::unique_ptr<Simulator<D>> make_simulator(const Scene& scene, const Setup<D>& setup,
                                             const Mutation& mutation, const Streams& streams,
                                             std::vector<Plane>* planes, EventSink<D>* trace);

/// One plane per observer that needs one, in order.
std::vector<Plane> make_planes(const std::vector<ObserverSpec>& observers);

}  // namespace sandglass
