#pragma once

#include "sim/method/event_driven/engine.hpp"

#include <algorithm>

namespace sandglass::event_driven {

// Engine: what happens from event to event.

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
  tally_.candidates = counts_.predictions;
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
  ++counts_.crossings;
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
    cells_.heads_ahead(cell, axis, up, near_);
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
  const Impact<D> impact = rule_.apply(gas_, i, j, normal, now_, counts_.guarded);
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
    counts_.guarded += visitor.guarded;
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
void Engine<D, F, M>::predict(std::uint32_t particle) {
  ++counts_.predictions;
  note(particle, first_contact(particle));
  calendar_.push(gas_.next[particle].time, particle);
}

template <int D, class F, bool M>
Contact Engine<D, F, M>::first_contact(std::uint32_t particle) {
  Contact best;
  cells_.heads_around(gas_.next[particle].cell, near_);
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
void Engine<D, F, M>::tell(std::uint32_t i, std::uint32_t j, const Vector<D>& normal, double approach) {
  const Body<D>& first = gas_.bodies[i];
  const bool agent = j >= kFirstAgent;
  trace_->hear({agent ? Event<D>::Kind::agent : Event<D>::Kind::collision, clock(), name(i),
                agent ? j - kFirstAgent : name(j), first.position, normal, first.velocity,
                agent ? Vector<D>(Vector<D>::Zero()) : gas_.bodies[j].velocity, approach});
}

}  // namespace sandglass::event_driven
