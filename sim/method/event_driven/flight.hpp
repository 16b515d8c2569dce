#pragma once

#include "sim/method/event_driven/particle.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

/// Motion between events, without a force. The differences of two flights are straight in both cases.
template <int D>
struct Straight {
  static constexpr bool falls = false;
  explicit Straight(const Vector<D>&) {}

  Vector<D> position(const Body<D>& body, double now) const {
    return body.position + (now - body.time) * body.velocity;
  }
  Vector<D> velocity(const Body<D>& body, double) const { return body.velocity; }
  double acceleration(int) const { return 0; }
};

/// Motion under a uniform acceleration.
template <int D>
struct Falling {
  static constexpr bool falls = true;
  Vector<D> gravity;
  explicit Falling(const Vector<D>& g) : gravity(g) {}

  Vector<D> position(const Body<D>& body, double now) const {
    const double age = now - body.time;
    return body.position + age * (body.velocity + 0.5 * age * gravity);
  }
  Vector<D> velocity(const Body<D>& body, double now) const {
    return body.velocity + (now - body.time) * gravity;
  }
  double acceleration(int axis) const { return gravity[axis]; }
};

/// Brings a body to `now`.
template <int D, class Flight>
void advance(const Flight& flight, Body<D>& body, double now) {
  body.position = flight.position(body, now);
  body.velocity = flight.velocity(body, now);
  body.time = now;
}

}  // namespace sandglass::event_driven
