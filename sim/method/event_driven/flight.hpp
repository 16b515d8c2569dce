#pragma once

#include "sim/method/event_driven/particle.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

/// Motion between events along one axis, of one particle or of four, without a force. The differences of two flights are
/// straight in both cases.
template <int D>
struct StraightAxes {
  static constexpr bool falls = false;
  explicit StraightAxes(const Vector<D>&) {}

  template <class Real>
  Real place(Real x, Real v, Real age, int) const {
    return x + age * v;
  }
  template <class Real>
  Real speed(Real v, Real, int) const {
    return v;
  }
  double acceleration(int) const { return 0; }
};

/// Motion under a uniform acceleration.
template <int D>
struct FallingAxes {
  static constexpr bool falls = true;
  Vector<D> gravity;
  explicit FallingAxes(const Vector<D>& g) : gravity(g) {}

  template <class Real>
  Real place(Real x, Real v, Real age, int axis) const {
    return x + age * (v + 0.5 * age * gravity[axis]);
  }
  template <class Real>
  Real speed(Real v, Real age, int axis) const {
    return v + age * gravity[axis];
  }
  double acceleration(int axis) const { return gravity[axis]; }
};

/// The same along all axes.
template <int D, class Axes>
struct Motion : Axes {
  using Axes::Axes;

  Vector<D> position(const Particle<D>& particle, double now) const {
    Vector<D> position;
    for (int axis = 0; axis < D; ++axis)
      position[axis] =
          this->place(particle.position[axis], particle.velocity[axis], now - particle.time, axis);
    return position;
  }
  Vector<D> velocity(const Particle<D>& particle, double now) const {
    Vector<D> velocity;
    for (int axis = 0; axis < D; ++axis)
      velocity[axis] = this->speed(particle.velocity[axis], now - particle.time, axis);
    return velocity;
  }
};

template <int D>
using Straight = Motion<D, StraightAxes<D>>;
template <int D>
using Falling = Motion<D, FallingAxes<D>>;

/// Brings a particle to `now`.
template <int D, class Flight>
void advance(const Flight& flight, Particle<D>& particle, double now) {
  const Vector<D> position = flight.position(particle, now);
  particle.velocity = flight.velocity(particle, now);
  particle.position = position;
  particle.time = now;
}

}  // namespace sandglass::event_driven
