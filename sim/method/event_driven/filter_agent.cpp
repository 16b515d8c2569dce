#include "sim/method/event_driven/filter_agent.hpp"

#include "sim/base/saved.hpp"
#include "sim/method/event_driven/books.hpp"
#include "sim/method/event_driven/heavy.hpp"
#include "sim/observe/axes.hpp"
#include "sim/space/flight.hpp"

namespace sandglass::event_driven {

template <int D>
Box<D> FilterAgent<D>::reach() const {
  Box<D> box = Box<D>::everywhere();
  box.low[place_.axis] = box.high[place_.axis] = place_.edge;
  return box;
}

template <int D>
double FilterAgent<D>::delay(const ParticleState<D>& particle, double) const {
  if (particle.species == kHeavy) return HUGE_VAL;
  return time_to_wall(particle.position[place_.axis], particle.velocity[place_.axis], 0, place_.edge,
                      place_.high ? 1 : -1);
}

template <int D>
Outcome FilterAgent<D>::act(ParticleState<D>& particle, double, Random& random) {
  const Vector<D> before = particle.velocity;
  const bool turned = backflow_.turns(particle, random);
  if (!turned) {
    particle.velocity = velocity_;
    particle.species = kHeavy;
  }
  turned_ += turned;
  note_change(impulses_, place_.number(), particle, before);
  return turned ? Outcome::replaced : Outcome::converted;
}

template <int D>
void FilterAgent<D>::act(ParticleAccess<D>& particles, double) {
  begun_ = true;
  for (std::uint32_t i = 0; i < particles.numbers(); ++i) {
    if (!particles.is_here(i)) continue;
    ParticleState<D> particle = particles.state(i);
    const double x = particle.position[place_.axis];
    if (place_.high ? x <= place_.edge : x >= place_.edge) continue;
    const Vector<D> before = particle.velocity;
    particle.velocity = velocity_;
    note_change(impulses_, place_.number(), particle, before);
    particles.convert(i, kHeavy, velocity_);
  }
}

template <int D>
void FilterAgent<D>::count(std::map<std::string, double>& counters) const {
  counters["particles-turned-" + side_name(place_.axis, place_.high)] = static_cast<double>(turned_);
}

template <int D>
std::vector<double> FilterAgent<D>::save() const {
  return {static_cast<double>(begun_), static_cast<double>(turned_)};
}

template <int D>
void FilterAgent<D>::load(const std::vector<double>& state) {
  begun_ = state.at(0) != 0;
  turned_ = saved_count(state.at(1));
}

template class FilterAgent<2>;

}  // namespace sandglass::event_driven
