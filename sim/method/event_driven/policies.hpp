#pragma once

#include "sim/method/event_driven/faults.hpp"
#include "sim/method/event_driven/flight.hpp"

// The choices that the engine is compiled for. An absent feature compiles to nothing.

namespace sandglass::event_driven {

/// The engine as it should be.
struct Honest {
  explicit Honest(const Faults&) {}

  /// Whether a contact is carried out though its partner has changed since it was predicted.
  bool accepts_stale() const { return false; }
  /// Whether a particle that enters a cell searches those that have become neighbours.
  bool looks_ahead() const { return true; }
  /// Has the last word on the velocity that the second partner leaves a collision with.
  template <int D>
  void finish_collision(const Vector<D>& before, Vector<D>& velocity) const {
    (void)before, (void)velocity;
  }
};

/// The same with the faults of the mutant suite.
struct Faulty {
  Faults faults;
  explicit Faulty(const Faults& planted) : faults(planted) {}

  bool accepts_stale() const { return faults.stale_partner; }
  bool looks_ahead() const { return !faults.blind_crossing; }
  template <int D>
  void finish_collision(const Vector<D>& before, Vector<D>& velocity) const {
    velocity += faults.momentum_leak * (before - velocity);
  }
};

template <int Dimension, class FlightPolicy, bool SeveralSpecies, class FaultPolicy = Honest>
struct Choice {
  static constexpr int D = Dimension;
  static constexpr bool mixed = SeveralSpecies;
  using Flight = FlightPolicy;  ///< Straight or Falling
  using Conduct = FaultPolicy;  ///< Honest or Faulty
};

/// The faulty engine is compiled once a dimension, for anything: it falls, if only at no acceleration.
template <int D>
using FaultyChoice = Choice<D, Falling<D>, true, Faulty>;

}  // namespace sandglass::event_driven
