#include "sim/method/event_driven/obstacle_agent.hpp"

#include "sim/method/event_driven/bounce.hpp"
#include "sim/physics/obstacle_flight.hpp"

namespace sandglass::event_driven {

template <int D>
bool ObstacleAgent<D>::reaches(const Vector<D>& low, const Vector<D>& high) const {
  const Vector<D> nearest = centre_.cwiseMax(low).cwiseMin(high);
  return (nearest - centre_).norm() <= reach_ * (1 + 1e-9);
}

template <int D>
double ObstacleAgent<D>::delay(const Guest<D>& guest, double) const {
  return time_to_obstacle<D>(guest.position - centre_, guest.velocity, gravity_, radius_ + guest.radius);
}

template <int D>
bool ObstacleAgent<D>::act(Guest<D>& guest, double, Random& random) {
  const Vector<D> normal = (guest.position - centre_).normalized();
  bounce<D>(rule_, normal, Vector<D>::Zero(), guest, random);
  return true;
}

template class ObstacleAgent<2>;
template class ObstacleAgent<3>;

}  // namespace sandglass::event_driven
