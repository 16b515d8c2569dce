#pragma once

#include "sim/method/event_driven/check_codes.hpp"
#include "sim/method/event_driven/engine.hpp"

#include <algorithm>

namespace sandglass::event_driven {

// Engine: particles that come and go. Who leaves is out of its cell at once; its place stays empty until the next era, so
// that the numbers of all others stay what they are.

template <class C>
bool Engine<C>::has_room(const Vector<D>& position, std::size_t species) {
  cells_.heads_around(cells_.cell_of(position), near_);
  for (std::uint32_t k = 0; k < near_.size(); ++k)
    for (std::uint32_t other = near_[k]; other != kNobody; other = gas_.particles[other].below) {
      const Vector<D> there = flight_.position(gas_.particles[other], progress_.now);
      const double reach = search_.reach(species, gas_.kind(other));
      if (search_.nearest(position - there).squaredNorm() < reach * reach) return false;
    }
  return true;
}

template <class C>
void Engine<C>::convert(std::uint32_t particle, std::size_t species, const Vector<D>& velocity) {
  gas_.species[particle] = static_cast<std::uint8_t>(species);
  set_velocity(particle, velocity);
}

template <class C>
void Engine<C>::insert(const Newcomer<D>& newcomer) {
  check_codes(gas_.size() + std::uint64_t{1}, agents_.size());
  fills_ = parameters_.gravity.isZero(0);
  const std::uint32_t particle = gas_.size();
  gas_.append(newcomer, progress_.now, next_id_++);
  gas_.next[particle].cell = cells_.cell_of(newcomer.position);
  cells_.enter(gas_.particles.data(), particle, gas_.next[particle].cell);
  predict(particle);
  ++progress_.exchanges;
}

template <class C>
void Engine<C>::remove(std::uint32_t particle) {
  cells_.leave(gas_.particles.data(), particle, gas_.next[particle].cell);
  gas_.drop(particle);
  ++progress_.exchanges;
}

/// The calendar is laid out for so many particles: it is laid out anew when a quarter has come or gone.
template <class C>
void Engine<C>::renew_era() {
  if (progress_.exchanges > 64 + size() / 4) begin_era();
}

template <class C>
void Engine<C>::insert(const Particles<D>& particles) {
  const auto species = particles.columns.get(column::species);
  const auto spins = particles.columns.get(column::spin<D>);
  for (std::size_t i = 0; i < particles.phases.size(); ++i) {
    Newcomer<D> newcomer{particles.phases[i].position, particles.phases[i].velocity};
    if (!species.empty()) newcomer.species = species[i];
    if (!spins.empty()) newcomer.spin = spins[i];
    insert(newcomer);
  }
  seen_ = -1;
  renew_era();
}

template <class C>
void Engine<C>::remove(std::span<const std::uint32_t> places) {
  const std::vector<std::uint32_t> here = gas_.places();
  for (const std::uint32_t place : places) remove(here.at(place));
  seen_ = -1;
  renew_era();
}

template <class C>
void Engine<C>::enter(const Entrants<D>& entrants, double dt, std::uint64_t) {
  open_entrance();
  entrance_.expect(entrants, progress_.clock() + dt);
}

/// The loop of a scene where nobody comes in does not ask it.
template <class C>
void Engine<C>::open_entrance() {
  if (std::ranges::find(timers_, &entrance_) == timers_.end()) timers_.push_back(&entrance_);
}

template <class C>
void Engine<C>::let_go(std::uint32_t particle, std::uint32_t agent) {
  advance(flight_, gas_.particles[particle], progress_.now);
  if (trace_ != nullptr) trace(particle, kFirstAgent + agent, Vector<D>::Zero(), 0);
  remove(particle);
}

}  // namespace sandglass::event_driven
