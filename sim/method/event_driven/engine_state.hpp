#pragma once

#include "sim/base/error.hpp"
#include "sim/method/event_driven/engine.hpp"
#include "sim/method/event_driven/restart.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass::event_driven {

// Engine: particles in and out, eras, views and restarts.

template <int D, class F, bool M>
Engine<D, F, M>::Engine(const Parameters<D>& parameters, Agents<D> agents, const Streams& streams,
                        EventSink<D>* trace)
    : parameters_(parameters),
      flight_(parameters.gravity),
      cells_(parameters.geometry, parameters.cell_edge()),
      search_(parameters, flight_),
      rule_(parameters),
      agents_(std::move(agents)),
      streams_(streams),
      trace_(trace) {
  tally_.impact.assign(parameters.impact_bins, 0);
  watch_cells();
}

template <int D, class F, bool M>
void Engine<D, F, M>::watch_cells() {
  if (agents_.empty()) return;
  watched_.assign(cells_.size(), 0);
  for (const std::uint32_t cell : cells_.all()) {
    Vector<D> low, high;
    for (int axis = 0; axis < D; ++axis) {
      low[axis] = cells_.edge(cell, axis, false);
      high[axis] = cells_.edge(cell, axis, true);
    }
    for (const auto& agent : agents_)
      if (agent->reaches(low, high)) watched_[cells_.linear(cell)] = 1;
  }
}

template <int D, class F, bool M>
void Engine<D, F, M>::assign(const Particles<D>& particles) {
  gas_.assign(particles, parameters_);
  for (std::uint32_t i = 0; i < gas_.size(); ++i) gas_.next[i].cell = cells_.cell_of(gas_.bodies[i].position);
  now_ = origin_ = 0;
  drawn_ = 0;
  stall_ = {};
  stall_.set_size(particles.phases.size());
  seen_ = -1;
  prefetches_ = Prefetch<D>::pays(gas_.size());
  gas_.reorder(order_by_cell(gas_, cells_));
  fill_cells();
  for (std::uint32_t i = 0; i < gas_.size(); ++i) note(i, first_contact(i));
  era_ = plan_era(gas_);
  events_ = 0;
  fill_calendar();
}

template <int D, class F, bool M>
void Engine<D, F, M>::begin_era() {
  gas_.rebase(now_);
  stall_.rebase(now_);
  origin_ += now_;
  now_ = 0;
  gas_.reorder(order_by_cell(gas_, cells_));
  fill_cells();
  era_ = plan_era(gas_);
  events_ = 0;
  fill_calendar();
}

template <int D, class F, bool M>
void Engine<D, F, M>::fill_cells() {
  cells_.clear();
  for (std::uint32_t i = 0; i < gas_.size(); ++i) cells_.enter(gas_.bodies.data(), i, gas_.next[i].cell);
}

template <int D, class F, bool M>
void Engine<D, F, M>::fill_calendar() {
  scale_stall();
  calendar_.start(era_.width, era_.buckets);
  for (std::uint32_t i = 0; i < gas_.size(); ++i) calendar_.push(gas_.next[i].time, i);
}

/// An era shrinks along with the bounces of a ball. Gravity and the diameter have a speed and a time that do not.
template <int D, class F, bool M>
void Engine<D, F, M>::scale_stall() {
  const double g = parameters_.gravity.norm(), d = parameters_.largest_diameter();
  const double era = era_.end() < HUGE_VAL ? era_.end() : 0;
  stall_.set_scale(std::max(speed_scale(gas_), std::sqrt(g * d)),
                   std::max(era, g > 0 ? std::sqrt(d / g) : 0));
}

template <int D, class F, bool M>
void Engine<D, F, M>::redirect(std::uint32_t particle, const Vector<D>& velocity) {
  Body<D>& body = gas_.bodies[particle];
  advance(flight_, body, now_);
  body.velocity = velocity;
  ++body.changes;
  predict(particle);
}

template <int D, class F, bool M>
Guest<D> Engine<D, F, M>::guest_at(std::uint32_t particle, double time) const {
  const Body<D>& body = gas_.bodies[particle];
  const std::size_t kind = gas_.kind(particle);
  const SpeciesTraits& traits = parameters_.species[kind];
  return {flight_.position(body, time),
          flight_.velocity(body, time),
          nullptr,
          traits.diameter / 2,
          traits.mass,
          traits.inertia,
          kind,
          false};
}

template <int D, class F, bool M>
void Engine<D, F, M>::refuse_collapse(std::uint32_t i, std::uint32_t j) const {
  const auto who = [this](std::uint32_t particle) {
    std::string place;
    for (const double x : guest(particle).position)
      place += fmt::format("{}{:.6g}", place.empty() ? "" : ", ", x);
    return gas_.ids.empty() ? fmt::format("a particle at ({})", place)
                            : fmt::format("particle {} at ({})", gas_.ids[particle], place);
  };
  throw RunError(collapse_message(clock(), who(i), i == j ? "a wall or obstacle" : who(j), F::falls));
}

template <int D, class F, bool M>
View<D> Engine<D, F, M>::view() {
  if (seen_ != clock())
    present_.take(size(), parameters_.geometry, [this](std::uint32_t i) { return guest(i); });
  seen_ = clock();
  View<D> view = present_.view();
  view.spins = gas_.spins;
  view.species = gas_.species;
  view.traits = parameters_.species;
  view.mass = parameters_.species.front().mass;
  view.tally = &tally_;
  view.planes = parameters_.planes;
  return view;
}

template <int D, class F, bool M>
std::map<std::string, double> Engine<D, F, M>::counters() const {
  return {{"cell-crossings", static_cast<double>(counts_.crossings)},
          {"predictions", static_cast<double>(counts_.predictions)},
          {"guarded-collisions", static_cast<double>(counts_.guarded)},
          {"deepest-overlap", tally_.deepest_overlap}};
}

template <int D, class F, bool M>
Memory Engine<D, F, M>::save() const {
  Memory memory;
  save_gas(gas_, memory);
  for (std::size_t a = 0; a < agents_.size(); ++a)
    memory[fmt::format("event-driven/agent-{}", a)] = agents_[a]->save();
  memory["event-driven/clock"] = {now_,
                                  origin_,
                                  era_.width,
                                  static_cast<double>(era_.buckets),
                                  static_cast<double>(drawn_),
                                  static_cast<double>(events_),
                                  static_cast<double>(era_.most_events)};
  memory["event-driven/counts"] = {static_cast<double>(counts_.crossings),
                                   static_cast<double>(counts_.predictions),
                                   static_cast<double>(counts_.guarded)};
  return memory;
}

template <int D, class F, bool M>
void Engine<D, F, M>::load(const Memory& memory) {
  load_gas(memory, gas_);
  for (std::size_t a = 0; a < agents_.size(); ++a)
    agents_[a]->load(memory.at(fmt::format("event-driven/agent-{}", a)));
  const std::vector<double>& clock = memory.at("event-driven/clock");
  now_ = clock.at(0);
  origin_ = clock.at(1);
  era_ = {clock.at(2), static_cast<std::size_t>(clock.at(3)), static_cast<std::uint64_t>(clock.at(6))};
  events_ = static_cast<std::uint64_t>(clock.at(5));
  drawn_ = static_cast<std::uint64_t>(clock.at(4));
  const std::vector<double>& counts = memory.at("event-driven/counts");
  counts_ = {static_cast<std::uint64_t>(counts.at(0)), static_cast<std::uint64_t>(counts.at(1)),
             static_cast<std::uint64_t>(counts.at(2))};
  seen_ = -1;
  fill_cells();
  fill_calendar();
}

template <int D, class F, bool M>
std::size_t Engine<D, F, M>::bytes() const {
  return gas_.bytes() + cells_.bytes() + calendar_.bytes() + watched_.capacity() + present_.bytes();
}

}  // namespace sandglass::event_driven
