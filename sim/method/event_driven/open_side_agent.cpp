#include "sim/method/event_driven/open_side_agent.hpp"

#include "sim/method/event_driven/bounce.hpp"
#include "sim/observe/axes.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

template <int D>
Box<D> OpenSideAgent<D>::reach() const {
  Box<D> box = Box<D>::everywhere();
  box.low[place_.axis] = box.high[place_.axis] = place_.edge;
  return box;
}

template <int D>
double OpenSideAgent<D>::delay(const ParticleState<D>& particle, double) const {
  return time_to_wall(particle.position[place_.axis], particle.velocity[place_.axis], gravity_, place_.edge,
                      place_.high ? 1 : -1);
}

template <int D>
Outcome OpenSideAgent<D>::act(ParticleState<D>& particle, double, Random&) {
  ++left_;
  if (impulses_ != nullptr)
    impulses_->add(place_.number(), particle.mass * particle.velocity, Vector<D>::Zero(),
                   energy_beside<D>(Vector<D>::Zero(), at_wall(particle)));
  return Outcome::gone;
}

template <int D>
void OpenSideAgent<D>::count(std::map<std::string, double>& counters) const {
  counters["particles-left"] += static_cast<double>(left_);
  counters["particles-left-" + side_name(place_.axis, place_.high)] = static_cast<double>(left_);
}

template class OpenSideAgent<2>;
template class OpenSideAgent<3>;

}  // namespace sandglass::event_driven
