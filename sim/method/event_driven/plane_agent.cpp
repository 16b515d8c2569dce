#include "sim/method/event_driven/plane_agent.hpp"

#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

/// Strictly after now: who has just passed stands on the plane.
template <int D>
double PlaneAgent<D>::delay(const ParticleState<D>& particle, double) const {
  const double x = particle.position[plane_->axis()] - plane_->position(),
               v = particle.velocity[plane_->axis()];
  if (gravity_ == 0) return x * v < 0 ? -x / v : HUGE_VAL;
  if (x != 0) return time_to_wall(x, v, gravity_, 0, x < 0 ? 1 : -1);
  return v * gravity_ < 0 ? -2 * v / gravity_ : HUGE_VAL;
}

template <int D>
Outcome PlaneAgent<D>::act(ParticleState<D>& particle, double, Random&) {
  particle.position[plane_->axis()] = plane_->position();
  plane_->count(particle.velocity[plane_->axis()]);
  return Outcome::unchanged;
}

template class PlaneAgent<2>;
template class PlaneAgent<3>;

}  // namespace sandglass::event_driven
