#pragma once

#include "sim/base/saved.hpp"
#include "sim/base/stop_request.hpp"
#include "sim/method/event_driven/check_codes.hpp"
#include "sim/method/event_driven/engine.hpp"
#include "sim/method/event_driven/restart.hpp"

#include <algorithm>

#include <fmt/ranges.h>

namespace sandglass::event_driven {

// Engine: particles in and out, eras, views and restarts.

template <class C>
Engine<C>::Engine(const Parameters<D>& parameters, Agents<D> agents, const Streams& streams,
                  EventSink<D>* trace)
    : parameters_(parameters),
      conduct_(parameters_),
      flight_(parameters.gravity),
      cells_(parameters.geometry, parameters.cell_edge()),
      search_(parameters, flight_),
      rule_(parameters),
      agents_(std::move(agents)),
      agents_by_cell_(cells_, agents_),
      draws_(std::ranges::any_of(agents_, [](const auto& agent) { return agent->draws(); })),
      streams_(streams),
      trace_(trace),
      entrance_(parameters_, streams) {
  tally_.impact.assign(parameters.impact_bins, 0);
  if (parameters.count_by_species)
    tally_.by_species.assign(parameters.species.size() * parameters.species.size(), 0);
  for (const auto& agent : agents_)
    if (agent->next() < HUGE_VAL) timers_.push_back(agent.get());
}

template <class C>
void Engine<C>::assign(const Particles<D>& particles) {
  check_codes(particles.phases.size(), agents_.size());
  gas_.assign(particles, {.spins = parameters_.rough,
                          .species = C::mixed,
                          .last_contact = parameters_.contact_time > 0,
                          .ids = parameters_.keep_ids || draws_});
  for (std::uint32_t i = 0; i < gas_.size(); ++i)
    gas_.next[i].cell = cells_.cell_of(gas_.particles[i].position);
  progress_.now = progress_.origin = 0;
  progress_.counts.agent_events = 0;
  progress_.exchanges = 0;
  entrance_ = Entrance<D>(parameters_, streams_);
  next_id_ = gas_.size();
  for (const std::uint64_t id : gas_.ids) next_id_ = std::max(next_id_, id + 1);
  fills_ = false;
  quietest_ = HUGE_VAL;
  quiet_size_ = 0;
  stall_ = {};
  stall_.set_size(particles.phases.size());
  seen_ = -1;
  gas_.reorder(order_by_cell(gas_, cells_));
  fill_cells();
  for (std::uint32_t i = 0; i < gas_.size(); ++i) set_next(i, first_contact(i));
  begin_calendar();
}

template <class C>
void Engine<C>::begin_era() {
  stop_request.heed();
  if (fills_) refuse_jam();
  gas_.rebase(progress_.now);
  stall_.rebase(progress_.now);
  progress_.origin += progress_.now;
  progress_.now = 0;
  if (gas_.gone > 0) gas_.close_ranks();
  gas_.reorder(order_by_cell(gas_, cells_));
  fill_cells();
  begin_calendar();
}

template <class C>
void Engine<C>::begin_calendar() {
  progress_.era = plan_era(gas_);
  progress_.events = progress_.exchanges = 0;
  prefetches_ = Prefetch<D>::pays(gas_.size());
  fill_calendar();
}

template <class C>
void Engine<C>::fill_cells() {
  cells_.clear();
  for (std::uint32_t i = 0; i < gas_.size(); ++i) cells_.enter(gas_.particles.data(), i, gas_.next[i].cell);
}

template <class C>
void Engine<C>::fill_calendar() {
  scale_stall();
  calendar_.start(progress_.era.width, progress_.era.buckets);
  for (std::uint32_t i = 0; i < gas_.size(); ++i) calendar_.push(gas_.next[i].time, i);
}

/// An era shrinks along with the bounces of a ball. Gravity and the diameter have a speed and a time that do not.
/// Where more come in than go, particles are pressed together, or heated without bound, until the collisions of a step
/// have no end. A gas collides as often in each step as long as their number is about the same.
template <class C>
void Engine<C>::refuse_jam() const {
  const double often = collisions_of_step();
  if (!(often > kMostOften) || !(often > kJam * quietest_)) return;
  const Vector<D> place = state(0).position;
  throw RunError(fmt::format(
      "time hardly advances at {:.12g}: the {} particles in the box, one of them at ({:.6g}), have collided "
      "{:.3g} times each in "
      "this step, and at most {:.3g} times in a quiet one; the box is full, and more come in: open a side by "
      "which they "
      "leave, let fewer in, or end the run sooner",
      progress_.clock(), size(), fmt::join(place.data(), place.data() + D, ", "), often, quietest_));
}

template <class C>
void Engine<C>::note_quiet_step() {
  if (!fills_) return;
  if (size() > 4 * quiet_size_) {
    quietest_ = HUGE_VAL;
    quiet_size_ = size();
  }
  quietest_ = std::min(quietest_, collisions_of_step());
}

template <class C>
void Engine<C>::scale_stall() {
  const double g = parameters_.gravity.norm(), d = parameters_.largest_diameter();
  const double era = progress_.era.end() < HUGE_VAL ? progress_.era.end() : 0;
  stall_.set_scale(std::max(speed_scale(gas_), std::sqrt(g * d)),
                   std::max(era, g > 0 ? std::sqrt(d / g) : 0));
}

template <class C>
void Engine<C>::set_velocity(std::uint32_t particle, const Vector<D>& velocity) {
  Particle<D>& changed = gas_.particles[particle];
  advance(flight_, changed, progress_.now);
  changed.velocity = velocity;
  ++changed.changes;
  predict(particle);
}

template <class C>
auto Engine<C>::state_at(std::uint32_t particle, double time) const -> ParticleState<D> {
  const Particle<D>& known = gas_.particles[particle];
  const std::size_t kind = gas_.kind(particle);
  const SpeciesTraits& traits = parameters_.species[kind];
  return {flight_.position(known, time),
          flight_.velocity(known, time),
          nullptr,
          traits.diameter / 2,
          traits.mass,
          traits.inertia,
          kind,
          false};
}

template <class C>
void Engine<C>::refuse_collapse(std::uint32_t i, std::uint32_t j) const {
  const auto describe = [this](std::uint32_t particle) {
    const Vector<D> position = state(particle).position;
    return describe_particle({position.data(), D}, gas_.ids.empty() ? nullptr : &gas_.ids[particle]);
  };
  throw RunError(collapse_message(progress_.clock(), describe(i), i == j ? "a wall or obstacle" : describe(j),
                                  !parameters_.gravity.isZero(0)));
}

template <class C>
auto Engine<C>::view() -> View<D> {
  if (seen_ != progress_.clock())
    present_.take(gas_, parameters_.geometry, [this](std::uint32_t i) { return state(i); });
  seen_ = progress_.clock();
  View<D> view = present_.view();
  if (parameters_.keep_ids) view.columns.add(column::id, present_.ids(gas_));
  view.columns.add(column::spin<D>, present_.spins(gas_));
  if (parameters_.own_species() > 1) view.columns.add(column::species, present_.species(gas_));
  view.traits = std::span(parameters_.species).first(parameters_.own_species());
  view.tally = &tally_;
  view.planes = parameters_.planes;
  return view;
}

/// Of the last view, if somebody has left.
template <class C>
std::span<const std::uint64_t> Engine<C>::ids() const {
  if (!parameters_.keep_ids) return {};
  return present_.ids(gas_);
}

template <class C>
std::map<std::string, double> Engine<C>::counters() const {
  std::map<std::string, double> counters{
      {"cell-crossings", static_cast<double>(progress_.counts.crossings)},
      {"predictions", static_cast<double>(progress_.counts.predictions)},
      {"guarded-collisions", static_cast<double>(progress_.counts.guarded)},
      {"deepest-overlap", tally_.deepest_overlap}};
  for (const auto& agent : agents_) agent->count(counters);
  if (entrance_.used()) entrance_.count(counters);
  return counters;
}

template <class C>
Memory Engine<C>::save() const {
  if (gas_.gone > 0) {
    Gas<D> here = gas_;
    here.close_ranks();
    return with_entrance(save_state(here, agents_, progress_));
  }
  return with_entrance(save_state(gas_, agents_, progress_));
}

template <class C>
Memory Engine<C>::with_entrance(Memory memory) const {
  memory[kNextId] = {static_cast<double>(next_id_)};
  if (entrance_.used()) memory[kEntrance] = entrance_.save();
  return memory;
}

template <class C>
void Engine<C>::load(const Memory& memory) {
  load_state(memory, gas_, agents_, progress_);
  require_sound(gas_, cells_, agents_.size(), parameters_.species.size(), progress_);
  for (const Agent<D>* timer : timers_)
    if (timer != &entrance_ && timer->next() < progress_.clock() * (1 - 1e-9))
      refuse_saved("an event long past");
  next_id_ = saved_count(memory.at(kNextId).at(0));
  if (const auto known = memory.find(kEntrance); known != memory.end()) {
    entrance_.load(known->second);
    open_entrance();
  }
  seen_ = -1;
  fill_cells();
  fill_calendar();
}

template <class C>
std::size_t Engine<C>::bytes() const {
  return gas_.bytes() + cells_.bytes() + calendar_.bytes() + agents_by_cell_.bytes() + present_.bytes();
}

}  // namespace sandglass::event_driven
