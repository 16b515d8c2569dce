#pragma once

#include "sim/method/event_driven/faults.hpp"
#include "sim/method/event_driven/flight.hpp"
#include "sim/method/event_driven/heavy.hpp"

// The choices that the engine is compiled for. An absent feature compiles to nothing.

namespace sandglass::event_driven {

/// The engine as it should be.
struct Honest {
  template <int D>
  explicit Honest(const Parameters<D>&) {}

  /// Whether a contact is carried out though its partner has changed since it was predicted.
  bool accepts_stale() const { return false; }
  /// Whether a particle that enters a cell searches those that have become neighbours.
  bool looks_ahead() const { return true; }
  /// The collision itself.
  template <int D>
  Impact<D> collide(const CollisionRule<D>& rule, Gas<D>& gas, std::uint32_t first, std::uint32_t second,
                    const Vector<D>& normal, double now, std::uint64_t& guarded) const {
    return rule.apply(gas, first, second, normal, now, guarded);
  }
  /// Has the last word on the velocity that the second partner leaves a collision with.
  template <int D>
  void finish_collision(const Vector<D>& before, Vector<D>& velocity) const {
    (void)before, (void)velocity;
  }
};

/// The same with the faults of the mutant suite.
struct Faulty : Honest {
  Faults faults;
  template <int D>
  explicit Faulty(const Parameters<D>& parameters) : Honest(parameters), faults(parameters.faults) {}

  bool accepts_stale() const { return faults.stale_partner; }
  bool looks_ahead() const { return !faults.blind_crossing; }
  template <int D>
  void finish_collision(const Vector<D>& before, Vector<D>& velocity) const {
    velocity += faults.momentum_leak * (before - velocity);
  }
};

/// Some particles have passed a filter.
template <int Dimension>
struct WithHeavy : Honest {
  const Parameters<Dimension>& parameters;
  explicit WithHeavy(const Parameters<Dimension>& all) : Honest(all), parameters(all) {}

  template <int D>
  Impact<D> collide(const CollisionRule<D>& rule, Gas<D>& gas, std::uint32_t first, std::uint32_t second,
                    const Vector<D>& normal, double now, std::uint64_t& guarded) const {
    if (gas.species[first] != kHeavy && gas.species[second] != kHeavy)
      return rule.apply(gas, first, second, normal, now, guarded);
    return collide_with_heavy(parameters, rule, gas, first, second, normal, now, guarded);
  }
};

template <int Dimension, class FlightPolicy, bool SeveralSpecies, class FaultPolicy = Honest>
struct Choice {
  static constexpr int D = Dimension;
  static constexpr bool mixed = SeveralSpecies;
  using Flight = FlightPolicy;  ///< Straight or Falling
  using Conduct = FaultPolicy;  ///< Honest or Faulty
};

/// Behind a filter nobody falls.
template <int D>
using HeavyChoice = Choice<D, Straight<D>, true, WithHeavy<D>>;

/// The faulty engine is compiled once a dimension, for anything: it falls, if only at no acceleration.
template <int D>
using FaultyChoice = Choice<D, Falling<D>, true, Faulty>;

}  // namespace sandglass::event_driven
