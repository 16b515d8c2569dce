#include "sim/method/event_driven/engine.hpp"

#include "sim/base/error.hpp"
#include "sim/method/event_driven/restart.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass::event_driven {

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
      low[axis] = cells_.low_edge(cell, axis);
      high[axis] = cells_.high_edge(cell, axis);
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
void Engine<D, F, M>::step(double dt, std::uint64_t) {
  seen_ = -1;
  double left = dt;
  for (;;) {
    const auto next = std::ranges::min_element(agents_, {}, [](const auto& agent) { return agent->next(); });
    const double until = next == agents_.end() ? HUGE_VAL : (*next)->next() - clock();
    if (until > left) break;
    run_until(std::max(until, 0.0));
    left -= std::max(until, 0.0);
    (*next)->act(*this, clock());
  }
  run_until(left);
  tally_.moves = 2 * tally_.collisions + drawn_;
  tally_.candidates = tally_.predictions;
  tally_.transfer.add(transfer_);
  transfer_ = 0;
}

template <int D, class F, bool M>
void Engine<D, F, M>::run_until(double duration) {
  double end = now_ + duration;
  for (;;) {
    const EventCalendar::Entry* entry = calendar_.front();
    const bool crowded = events_ >= era_.most_events;
    if (entry == nullptr || crowded) {
      if (!crowded && !(era_.end() <= end)) break;
      if (!crowded) now_ = era_.end();
      end -= now_;
      begin_era();
      continue;
    }
    if (entry->time > end) break;
    const EventCalendar::Entry event = *entry;
    calendar_.pop();
    if (prefetches_) prefetch_(gas_, cells_, calendar_);
    if (gas_.next[event.owner].time != event.time) continue;
    now_ = event.time;
    ++events_;
    handle(event.owner);
  }
  now_ = end;
}

template <int D, class F, bool M>
void Engine<D, F, M>::handle(std::uint32_t particle) {
  const Next& next = gas_.next[particle];
  if (next.time < next.contact) return cross(particle);
  if (next.partner >= kFirstAgent) return meet(particle, next.partner - kFirstAgent);
  if (gas_.bodies[next.partner].changes != next.partner_changes && !parameters_.faults.stale_partner)
    return predict(particle);
  collide(particle, next.partner);
}

/// Only those cells are searched that were not neighbours before: what is known of the others stays as it is.
template <int D, class F, bool M>
void Engine<D, F, M>::cross(std::uint32_t particle) {
  ++tally_.crossings;
  Body<D>* bodies = gas_.bodies.data();
  Next& next = gas_.next[particle];
  const int axis = Exit::axis_of(next.exit);
  const bool up = Exit::up_of(next.exit);
  double shift = 0;
  const std::uint32_t cell = cells_.step(next.cell, axis, up, shift);
  cells_.leave(bodies, particle, next.cell);
  cells_.enter(bodies, particle, cell);
  next.cell = cell;
  bodies[particle].position[axis] += shift;
  Contact best{next.contact, next.partner};
  const Next known = next;
  if (!parameters_.faults.blind_crossing) {
    cells_.collect_ahead(bodies, cell, axis, up, near_);
    search_.earliest(gas_, particle, near_, now_, best);
  }
  ask_agents(particle, best);
  note(particle, best);
  if (best.partner == known.partner && best.time == known.contact)
    next.partner_changes = known.partner_changes;
  calendar_.push(next.time, particle);
}

template <int D, class F, bool M>
void Engine<D, F, M>::collide(std::uint32_t i, std::uint32_t j) {
  Body<D>&first = gas_.bodies[i], &second = gas_.bodies[j];
  advance(flight_, first, now_);
  advance(flight_, second, now_);
  const Vector<D> separation = search_.nearest(first.position - second.position);
  const double distance = separation.norm();
  const Vector<D> normal = separation / distance;
  const double overlap = 1 - distance / search_.reach(gas_.kind(i), gas_.kind(j));
  tally_.deepest_overlap = std::max(tally_.deepest_overlap, overlap);
  if (parameters_.impact_bins > 0) count_impact(normal, first.velocity - second.velocity);
  const Impact<D> impact = rule_.apply(gas_, i, j, normal, now_, tally_.guarded);
  part(normal, first.velocity, second.velocity);
  if (stall_.contact(now_, impact.approach)) refuse_collapse(i, j);
  if (parameters_.measure_transfer) transfer_ += impact.impulse.dot(separation);
  ++tally_.collisions;
  ++first.changes;
  ++second.changes;
  if (trace_ != nullptr) tell(i, j, normal, impact.approach);
  predict(i);
  predict(j);
}

template <int D, class F, bool M>
void Engine<D, F, M>::count_impact(const Vector<D>& normal, const Vector<D>& relative) {
  const double along = relative.dot(normal);
  const double square = std::max(0.0, 1 - along * along / relative.squaredNorm());
  const std::size_t bins = parameters_.impact_bins;
  ++tally_
        .impact[std::min(static_cast<std::size_t>(std::sqrt(square) * static_cast<double>(bins)), bins - 1)];
}

template <int D, class F, bool M>
void Engine<D, F, M>::meet(std::uint32_t particle, std::uint32_t agent) {
  Guest<D> visitor = guest(particle);
  if (!gas_.spins.empty()) visitor.spin = &gas_.spins[particle];
  Body<D>& body = gas_.bodies[particle];
  const Vector<D> before = visitor.velocity;
  visitor.guarded = rule_.guards(gas_, particle, now_);
  Random random(StreamKey(streams_.seed, Purpose::walls, streams_.replica, 0), drawn_++);
  if (agents_[agent]->act(visitor, clock(), random)) {
    ++body.changes;
    tally_.guarded += visitor.guarded;
    rule_.remember(gas_, particle, now_);
    if (stall_.contact(now_, (visitor.velocity - before).norm())) refuse_collapse(particle, particle);
  }
  body.position = visitor.position;
  body.velocity = visitor.velocity;
  body.time = now_;
  if (trace_ != nullptr) tell(particle, kFirstAgent + agent, Vector<D>::Zero(), 0);
  predict(particle);
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
void Engine<D, F, M>::predict(std::uint32_t particle) {
  ++tally_.predictions;
  note(particle, first_contact(particle));
  calendar_.push(gas_.next[particle].time, particle);
}

template <int D, class F, bool M>
Contact Engine<D, F, M>::first_contact(std::uint32_t particle) {
  Contact best;
  cells_.collect_around(gas_.bodies.data(), gas_.next[particle].cell, near_);
  search_.earliest(gas_, particle, near_, now_, best);
  ask_agents(particle, best);
  return best;
}

/// From the last change on, not from now: every look gives the same answer.
template <int D, class F, bool M>
void Engine<D, F, M>::ask_agents(std::uint32_t particle, Contact& best) const {
  if (watched_.empty() || watched_[cells_.linear(gas_.next[particle].cell)] == 0) return;
  const double since = gas_.bodies[particle].time;
  const Guest<D> visitor = guest_at(particle, since);
  for (std::uint32_t a = 0; a < agents_.size(); ++a) {
    const double time = std::max(since + agents_[a]->delay(visitor, origin_ + since), now_);
    if (time < HUGE_VAL && best.after(time, kFirstAgent + a)) best = {time, kFirstAgent + a};
  }
}

template <int D, class F, bool M>
void Engine<D, F, M>::note(std::uint32_t particle, const Contact& contact) {
  Next& next = gas_.next[particle];
  next.contact = contact.time;
  next.partner = contact.partner;
  next.partner_changes = contact.partner < kFirstAgent ? gas_.bodies[contact.partner].changes : 0;
  const Exit exit = first_exit(cells_, flight_, gas_.bodies[particle], next.cell, now_);
  next.exit = exit.code();
  next.time = std::min(contact.time, exit.time);
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
void Engine<D, F, M>::tell(std::uint32_t i, std::uint32_t j, const Vector<D>& normal, double approach) {
  const Body<D>& first = gas_.bodies[i];
  const bool agent = j >= kFirstAgent;
  trace_->hear({agent ? Event<D>::Kind::agent : Event<D>::Kind::collision, clock(), name(i),
                agent ? j - kFirstAgent : name(j), first.position, normal, first.velocity,
                agent ? Vector<D>(Vector<D>::Zero()) : gas_.bodies[j].velocity, approach});
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
std::map<std::string, std::vector<double>> Engine<D, F, M>::save() const {
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
  return memory;
}

template <int D, class F, bool M>
void Engine<D, F, M>::load(const std::map<std::string, std::vector<double>>& state) {
  load_gas(state, gas_);
  for (std::size_t a = 0; a < agents_.size(); ++a)
    agents_[a]->load(state.at(fmt::format("event-driven/agent-{}", a)));
  const std::vector<double>& clock = state.at("event-driven/clock");
  now_ = clock.at(0);
  origin_ = clock.at(1);
  era_ = {clock.at(2), static_cast<std::size_t>(clock.at(3)), static_cast<std::uint64_t>(clock.at(6))};
  events_ = static_cast<std::uint64_t>(clock.at(5));
  drawn_ = static_cast<std::uint64_t>(clock.at(4));
  seen_ = -1;
  fill_cells();
  fill_calendar();
}

template <int D, class F, bool M>
std::size_t Engine<D, F, M>::bytes() const {
  return gas_.bytes() + cells_.bytes() + calendar_.bytes() + watched_.capacity() + present_.bytes();
}

namespace {
template <int D, class F>
std::unique_ptr<Simulator<D>> choose_mix(const Parameters<D>& parameters, Agents<D> agents,
                                         const Streams& streams, EventSink<D>* trace) {
  if (parameters.species.size() > 1)
    return std::make_unique<Engine<D, F, true>>(parameters, std::move(agents), streams, trace);
  return std::make_unique<Engine<D, F, false>>(parameters, std::move(agents), streams, trace);
}
}  // namespace

template <int D>
std::unique_ptr<Simulator<D>> make_event_driven(const Parameters<D>& parameters, Agents<D> agents,
                                                const Streams& streams, EventSink<D>* trace) {
  if (parameters.gravity.isZero(0))
    return choose_mix<D, Straight<D>>(parameters, std::move(agents), streams, trace);
  return choose_mix<D, Falling<D>>(parameters, std::move(agents), streams, trace);
}

template std::unique_ptr<Simulator<2>> make_event_driven(const Parameters<2>&, Agents<2>, const Streams&,
                                                         EventSink<2>*);
template std::unique_ptr<Simulator<3>> make_event_driven(const Parameters<3>&, Agents<3>, const Streams&,
                                                         EventSink<3>*);

}  // namespace sandglass::event_driven
