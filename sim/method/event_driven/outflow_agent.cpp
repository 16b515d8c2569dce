#include "sim/method/event_driven/outflow_agent.hpp"

#include "sim/base/saved.hpp"
#include "sim/method/event_driven/books.hpp"
#include "sim/observe/axes.hpp"

namespace sandglass::event_driven {

template <int D>
Outcome OutflowAgent<D>::act(ParticleState<D>& particle, double now, Random& random) {
  const Vector<D> before = particle.velocity;
  if (!backflow_.turns(particle, random)) return side_.act(particle, now, random);
  ++turned_;
  note_change(impulses_, place_.number(), particle, before);
  return Outcome::replaced;
}

template <int D>
void OutflowAgent<D>::count(std::map<std::string, double>& counters) const {
  side_.count(counters);
  counters["particles-turned-" + side_name(place_.axis, place_.high)] = static_cast<double>(turned_);
}

template <int D>
std::vector<double> OutflowAgent<D>::save() const {
  std::vector<double> state = side_.save();
  state.push_back(static_cast<double>(turned_));
  return state;
}

template <int D>
void OutflowAgent<D>::load(const std::vector<double>& state) {
  side_.load(state);
  turned_ = saved_count(state.at(1));
}

template class OutflowAgent<2>;
template class OutflowAgent<3>;

}  // namespace sandglass::event_driven
