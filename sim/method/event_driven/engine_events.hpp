#pragma once

#include "sim/base/stop_request.hpp"
#include "sim/method/event_driven/engine.hpp"

#include <algorithm>

namespace sandglass::event_driven {

// Engine: what happens from event to event.

template <class C>
void Engine<C>::step(double dt, std::uint64_t) {
  seen_ = -1;
  before_step_ = tally_.collisions;
  size_before_step_ = size();
  double left = dt;
  for (;;) {
    stop_request.heed();
    const auto next = std::ranges::min_element(timers_, {}, [](const auto* timer) { return timer->next(); });
    const double until = next == timers_.end() ? HUGE_VAL : (*next)->next() - progress_.clock();
    if (until > left) break;
    run_until(std::max(until, 0.0));
    left -= std::max(until, 0.0);
    (*next)->act(*this, progress_.clock());
    renew_era();
  }
  run_until(left);
  note_quiet_step();
  tally_.moves = 2 * tally_.collisions + progress_.counts.agent_events;
  tally_.candidates = progress_.counts.predictions;
}

template <class C>
void Engine<C>::run_until(double duration) {
  const Era& era = progress_.era;
  double end = progress_.now + duration;
  for (;;) {
    const EventCalendar::Entry* entry = calendar_.front();
    const bool crowded = progress_.events >= era.most_events;
    if (entry == nullptr || crowded) {
      if (!crowded && !(era.end() <= end)) break;
      if (!crowded) progress_.now = era.end();
      end -= progress_.now;
      begin_era();
      continue;
    }
    if (entry->time > end) break;
    const EventCalendar::Entry event = *entry;
    calendar_.pop();
    if (prefetches_) prefetch_(gas_, cells_, calendar_);
    if (gas_.next[event.owner].time != event.time) continue;
    progress_.now = event.time;
    if (++progress_.events % kBetweenLooks == 0) stop_request.heed();
    carry_out(event.owner);
  }
  progress_.now = end;
}

template <class C>
void Engine<C>::carry_out(std::uint32_t particle) {
  const Next& next = gas_.next[particle];
  if (next.time < next.contact) return cross(particle);
  if (next.partner >= kFirstAgent) return collide_with_agent(particle, next.partner - kFirstAgent);
  if (gas_.particles[next.partner].changes != next.partner_changes &&
      !(conduct_.accepts_stale() && gas_.is_here(next.partner) && next.partner != particle))
    return predict(particle);
  collide(particle, next.partner);
}

/// Only those cells are searched that were not neighbours before: what is known of the others stays as it is.
template <class C>
void Engine<C>::cross(std::uint32_t particle) {
  ++progress_.counts.crossings;
  Particle<D>* particles = gas_.particles.data();
  Next& next = gas_.next[particle];
  const int axis = Exit::axis_of(next.exit);
  const bool up = Exit::up_of(next.exit);
  double shift = 0;
  const std::uint32_t cell = cells_.step(next.cell, axis, up, shift);
  cells_.leave(particles, particle, next.cell);
  cells_.enter(particles, particle, cell);
  next.cell = cell;
  particles[particle].position[axis] += shift;
  Contact best{next.contact, next.partner};
  const Next known = next;
  if (conduct_.looks_ahead()) {
    cells_.heads_ahead(cell, axis, up, near_);
    search_.earliest(gas_, particle, near_, progress_.now, best);
  }
  if (!agents_by_cell_.empty()) search_agents(particle, best);
  set_next(particle, best);
  if (best.partner == known.partner && best.time == known.contact)
    next.partner_changes = known.partner_changes;
  calendar_.push(next.time, particle);
}

template <class C>
void Engine<C>::collide(std::uint32_t i, std::uint32_t j) {
  const double now = progress_.now;
  Particle<D>&first = gas_.particles[i], &second = gas_.particles[j];
  advance(flight_, first, now);
  advance(flight_, second, now);
  const Vector<D> separation = search_.nearest(first.position - second.position);
  const double distance = separation.norm();
  const Vector<D> normal = separation / distance;
  const double overlap = 1 - distance / search_.reach(gas_.kind(i), gas_.kind(j));
  tally_.deepest_overlap = std::max(tally_.deepest_overlap, overlap);
  if (parameters_.impact_bins > 0) count_impact(normal, first.velocity - second.velocity);
  const Vector<D> before = second.velocity;
  const Impact<D> impact =
      conduct_.template collide<D>(rule_, gas_, i, j, normal, now, progress_.counts.guarded);
  conduct_.template finish_collision<D>(before, second.velocity);
  make_receding(normal, first.velocity, second.velocity);
  if (stall_.contact(now, impact.approach)) refuse_collapse(i, j);
  if (parameters_.measure_transfer) tally_.transfer.add(impact.impulse.dot(separation));
  ++tally_.collisions;
  if (parameters_.count_by_species)
    ++tally_.by_species[gas_.kind(i) * parameters_.species.size() + gas_.kind(j)];
  ++first.changes;
  ++second.changes;
  if (trace_ != nullptr) trace(i, j, normal, impact.approach);
  predict(i);
  predict(j);
}

template <class C>
void Engine<C>::count_impact(const Vector<D>& normal, const Vector<D>& relative) {
  const double along = relative.dot(normal);
  const double square = std::max(0.0, 1 - along * along / relative.squaredNorm());
  const std::size_t bins = parameters_.impact_bins;
  ++tally_
        .impact[std::min(static_cast<std::size_t>(std::sqrt(square) * static_cast<double>(bins)), bins - 1)];
}

template <class C>
void Engine<C>::collide_with_agent(std::uint32_t particle, std::uint32_t agent) {
  const double now = progress_.now;
  ParticleState<D> present = state(particle);
  if (!gas_.spins.empty()) present.spin = &gas_.spins[particle];
  const Vector<D> before = present.velocity;
  present.guarded = rule_.guards(gas_, particle, now);
  ++progress_.counts.agent_events;
  const Outcome outcome = act(agent, particle, present);
  if (outcome == Outcome::changed) {
    progress_.counts.guarded += present.guarded;
    rule_.set_last_contact(gas_, particle, now);
    if (stall_.contact(now, (present.velocity - before).norm())) refuse_collapse(particle, particle);
  } else if (outcome == Outcome::gone) {
    return let_go(particle, agent);
  } else if (outcome == Outcome::replaced) {
    rule_.set_last_contact(gas_, particle, -HUGE_VAL);  // it comes from beyond, where nobody knows
  } else if (outcome == Outcome::converted) {
    gas_.species[particle] = static_cast<std::uint8_t>(present.species);
  }
  Particle<D>& moved = gas_.particles[particle];
  moved.position = present.position;
  moved.velocity = present.velocity;
  moved.time = now;
  if (trace_ != nullptr) trace(particle, kFirstAgent + agent, Vector<D>::Zero(), 0);
  predict(particle);
}

/// Draws come from the particle's own stream, named by its identity and the number of its changes so far: whatever others
/// do meanwhile, and wherever, does not show.
template <class C>
Outcome Engine<C>::act(std::uint32_t agent, std::uint32_t particle, ParticleState<D>& present) {
  Agent<D>& acting = *agents_[agent];
  std::uint32_t& changes = gas_.particles[particle].changes;
  Random random;
  if (acting.draws())
    random = Random(StreamKey(streams_.seed, Purpose::walls, streams_.replica, identity(particle)), changes);
  const Outcome outcome = acting.act(present, progress_.clock(), random);
  if (outcome == Outcome::changed || outcome == Outcome::replaced || acting.draws())
    ++changes;  // no stream is used twice
  return outcome;
}

template <class C>
void Engine<C>::predict(std::uint32_t particle) {
  ++progress_.counts.predictions;
  set_next(particle, first_contact(particle));
  calendar_.push(gas_.next[particle].time, particle);
}

template <class C>
Contact Engine<C>::first_contact(std::uint32_t particle) {
  Contact best;
  cells_.heads_around(gas_.next[particle].cell, near_);
  search_.earliest(gas_, particle, near_, progress_.now, best);
  if (!agents_by_cell_.empty()) search_agents(particle, best);
  return best;
}

/// From the last change on, not from now: every look gives the same answer.
template <class C>
void Engine<C>::search_agents(std::uint32_t particle, Contact& best) const {
  const auto near = agents_by_cell_[cells_.linear(gas_.next[particle].cell)];
  if (near.empty()) return;
  const double since = gas_.particles[particle].time;
  const ParticleState<D> past = state_at(particle, since);
  for (const std::uint32_t agent : near) {
    const double delay = agents_[agent]->delay(past, progress_.origin + since);
    const double time = std::max(since + delay, progress_.now);
    if (time < HUGE_VAL && best.after(time, kFirstAgent + agent)) best = {time, kFirstAgent + agent};
  }
}

template <class C>
void Engine<C>::set_next(std::uint32_t particle, const Contact& contact) {
  Next& next = gas_.next[particle];
  next.contact = contact.time;
  next.partner = contact.partner;
  next.partner_changes = contact.partner < kFirstAgent ? gas_.particles[contact.partner].changes : 0;
  const Exit exit = first_exit(cells_, flight_, gas_.particles[particle], next.cell, progress_.now);
  next.exit = exit.code();
  next.time = std::min(contact.time, exit.time);
}

template <class C>
void Engine<C>::trace(std::uint32_t i, std::uint32_t j, const Vector<D>& normal, double approach) {
  const Particle<D>& first = gas_.particles[i];
  const bool agent = j >= kFirstAgent;
  trace_->record({agent ? Event<D>::Kind::agent : Event<D>::Kind::collision, progress_.clock(), identity(i),
                  agent ? j - kFirstAgent : identity(j), first.position, normal, first.velocity,
                  agent ? Vector<D>(Vector<D>::Zero()) : gas_.particles[j].velocity, approach});
}

}  // namespace sandglass::event_driven
