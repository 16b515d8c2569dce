#include "sim/method/event_driven/obstacle_agent.hpp"

#include "sim/method/event_driven/bounce.hpp"
#include "sim/physics/obstacle_flight.hpp"

namespace sandglass::event_driven {

template <int D>
Box<D> ObstacleAgent<D>::reach() const {
  return {centre_.array() - reach_, centre_.array() + reach_};
}

template <int D>
bool ObstacleAgent<D>::reaches(const Box<D>& cell) const {
  const Vector<D> nearest = centre_.cwiseMax(cell.low).cwiseMin(cell.high);
  return (nearest - centre_).norm() <= reach_;
}

template <int D>
double ObstacleAgent<D>::delay(const ParticleState<D>& particle, double) const {
  return time_to_obstacle<D>(particle.position - centre_, particle.velocity, gravity_,
                             radius_ + particle.radius);
}

template <int D>
Outcome ObstacleAgent<D>::act(ParticleState<D>& particle, double, Random& random) {
  const Vector<D> normal = (particle.position - centre_).normalized();
  bounce<D>(rule_, normal, Vector<D>::Zero(), particle, random);
  return Outcome::changed;
}

template class ObstacleAgent<2>;
template class ObstacleAgent<3>;

}  // namespace sandglass::event_driven
