#pragma once

#include "sim/method/event_driven/contact_time.hpp"
#include "sim/method/event_driven/flight.hpp"
#include "sim/method/event_driven/gas.hpp"

namespace sandglass::event_driven {

struct Contact {
  double time = HUGE_VAL;
  std::uint32_t partner = kNobody;

  /// Of two at the same time the one with the lower number: the order of the search does not show.
  bool after(double other, std::uint32_t who) const {
    return time > other || (time == other && partner > who);
  }
};

/// Finds the earliest contact of one particle among candidates. The arithmetic runs over blocks of them, side by side.
template <int D, class Flight, bool Mixed>
class ContactSearch {
 public:
  ContactSearch(const Parameters<D>& parameters, const Flight& flight) : flight_(flight) {
    for (int axis = 0; axis < D; ++axis) {
      const bool periodic = parameters.geometry.periodic[static_cast<std::size_t>(axis)];
      box_[axis] = parameters.geometry.box[axis];
      per_box_[axis] = periodic ? 1 / box_[axis] : 0;
    }
    for (const SpeciesTraits& kind : parameters.species) radius_.push_back(kind.diameter / 2);
  }

  /// Shortest of the images of a separation.
  Vector<D> nearest(Vector<D> separation) const {
    for (int axis = 0; axis < D; ++axis)
      separation[axis] -= box_[axis] * std::rint(separation[axis] * per_box_[axis]);
    return separation;
  }

  /// `best` goes in with the earliest contact known so far. The particle itself may be among the candidates.
  void earliest(const Gas<D>& gas, std::uint32_t particle, Candidates& near, double now,
                Contact& best) const {
    const Body<D>& body = gas.bodies[particle];
    const Vector<D> position = flight_.position(body, now), velocity = flight_.velocity(body, now);
    const double radius = radius_[gas.kind(particle)];
    for (std::uint32_t first = 0; first < near.size; first += kBlock)
      search_block(gas, near.data() + first, std::min(kBlock, near.size - first), position, velocity, radius,
                   now, best);
  }

  double reach(std::size_t a, std::size_t b) const { return radius_[a] + radius_[b]; }

 private:
  static constexpr std::uint32_t kBlock = 32;

  void search_block(const Gas<D>& gas, const std::uint32_t* near, std::uint32_t count,
                    const Vector<D>& position, const Vector<D>& velocity, double radius, double now,
                    Contact& best) const {
    alignas(64) double r[D][kBlock], u[D][kBlock], reach[kBlock], time[kBlock];
    const Body<D>* bodies = gas.bodies.data();
    for (std::uint32_t k = 0; k < count; ++k) {
      const Body<D>& other = bodies[near[k]];
      const Vector<D> there = flight_.position(other, now), speed = flight_.velocity(other, now);
      for (int axis = 0; axis < D; ++axis) {
        r[axis][k] = position[axis] - there[axis];
        u[axis][k] = velocity[axis] - speed[axis];
      }
      if constexpr (Mixed) reach[k] = radius + radius_[gas.species[near[k]]];
    }
    const double diameter = 2 * radius;
    for (std::uint32_t k = 0; k < count; ++k) {
      double along = 0, square = 0, speed = 0;
      for (int axis = 0; axis < D; ++axis) {
        // Of two images half a box away the one that comes nearer.
        const double lean = std::copysign(1e-9, u[axis][k]);
        const double x = r[axis][k] - box_[axis] * std::rint(r[axis][k] * per_box_[axis] + lean);
        along += x * u[axis][k];
        square += x * x;
        speed += u[axis][k] * u[axis][k];
      }
      const double sum = Mixed ? reach[k] : diameter;
      time[k] = contact_time(along, square - sum * sum, speed);
    }
    for (std::uint32_t k = 0; k < count; ++k)
      if (best.after(now + time[k], near[k]) && time[k] < HUGE_VAL) best = {now + time[k], near[k]};
  }

  Flight flight_;
  double box_[D], per_box_[D];
  std::vector<double> radius_;
};

}  // namespace sandglass::event_driven
