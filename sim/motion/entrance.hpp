#pragma once

#include "sim/motion/bounded_flight.hpp"
#include "sim/space/particles.hpp"

#include <vector>

namespace sandglass::motion {

/// Entrants at the end of their step.
template <int D>
struct Arrived {
  Particles<D> particles;       ///< in the box
  std::vector<Vector<D>> left;  ///< outside, where a side let them out again
};

/// The way of particles that come in during a step, through what is left of it: the exact flight of all others, without
/// collisions.
template <int D>
class Entrance {
 public:
  Entrance(const MotionParameters<D>& parameters, const Vector<D>& box)
      : surfaces_(parameters, box), box_(box) {}

  Arrived<D> fly(const Entrants<D>& entrants, const MotionStep& step) const;

 private:
  void count(const Phase<D>& particle, const Arrival& arrival, const Body<D>& body) const;

  Surfaces<D> surfaces_;
  Vector<D> box_;
};

extern template class Entrance<2>;
extern template class Entrance<3>;

}  // namespace sandglass::motion
