#pragma once

#include "sim/method/event_driven/candidates.hpp"
#include "sim/method/event_driven/contact_time.hpp"
#include "sim/method/event_driven/flight.hpp"
#include "sim/method/event_driven/gas.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/space/quad.hpp"

namespace sandglass::event_driven {

struct Contact {
  double time = HUGE_VAL;
  std::uint32_t partner = kNobody;

  /// Of two at the same time the one with the lower number: the order of the search does not show.
  bool after(double other, std::uint32_t who) const {
    return time > other || (time == other && partner > who);
  }
};

/// Finds the earliest contact of one particle among candidates. The arithmetic runs over four of them side by side and has no
/// branches: half of all candidates recede and a fifth of the others hit, which no processor can guess.
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
    const Particle<D>& known = gas.particles[particle];
    const Moving self{flight_.position(known, now), flight_.velocity(known, now),
                      radius_[gas.kind(particle)]};
    Quad first = Quad{} + HUGE_VAL;
    WholeQuad partner{};
    while (near.more()) {
      const Candidates::Four four = near.next(gas.particles.data(), particle);
      const Quad time = contact_times(gas, self, four, now);
      const WholeQuad who{four[0], four[1], four[2], four[3]};
      const WholeQuad sooner = (time < first) | ((time == first) & (who < partner));
      first = sooner ? time : first;
      partner = sooner ? who : partner;
    }
    const double time = smallest(first);
    const auto who = static_cast<std::uint32_t>(smallest(first == time ? partner : WholeQuad{} + kNobody));
    if (time < HUGE_VAL && best.after(time, who)) best = {time, who};
  }

  double reach(std::size_t a, std::size_t b) const { return radius_[a] + radius_[b]; }

 private:
  /// The particle that searches, at the time of the search.
  struct Moving {
    Vector<D> position, velocity;
    double radius;
  };

  /// Times of the contacts with four others.
  Quad contact_times(const Gas<D>& gas, const Moving& self, const Candidates::Four& others,
                     double now) const {
    const Columns<D> four(gas.particles.data(), others);
    const Quad age = now - four.time();
    Quad along{}, square{}, speed{};
    for (int axis = 0; axis < D; ++axis) {
      const Quad v = four.velocity(axis);
      const Quad r = self.position[axis] - flight_.place(four.position(axis), v, age, axis);
      const Quad u = self.velocity[axis] - flight_.speed(v, age, axis);
      // Of two images half a box away the one that comes nearer.
      const Quad lean = u < 0 ? Quad{} - 1e-9 : Quad{} + 1e-9;
      const Quad x = r - box_[axis] * round_off(r * per_box_[axis] + lean);
      along += x * u;
      square += x * x;
      speed += u * u;
    }
    Quad sum = Quad{} + 2 * self.radius;
    if constexpr (Mixed)
      for (std::size_t k = 0; k < others.size(); ++k) sum[k] = self.radius + radius_[gas.species[others[k]]];
    return now + contact_time(along, square - sum * sum, speed);
  }

  Flight flight_;
  double box_[D], per_box_[D];
  std::vector<double> radius_;
};

}  // namespace sandglass::event_driven
