#include "sim/method/event_driven/backflow.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass::event_driven {

template <int D>
Backflow<D>::Backflow(const LeavingStream<D>& stream, const std::vector<SpeciesTraits>& species)
    : stream_(stream) {
  const double outward = stream.high ? 1 : -1;
  for (const SpeciesTraits& kind : species) {
    const double thermal = std::sqrt(stream.temperature / kind.mass);
    const StreamFlux<D> back(stream.velocity, thermal, stream.axis, -outward);
    const StreamFlux<D> out(stream.velocity, thermal, stream.axis, outward);
    returns_.push_back({back.rate() / out.rate(), thermal, back});
  }
}

template <int D>
bool Backflow<D>::turns(ParticleState<D>& particle, Random& random) const {
  const Return& back = returns_[particle.species];
  if (!(random.uniform() < back.share)) return false;
  particle.velocity = back.flux(random);
  if (stream_.maxwellian) {
    const double inward = stream_.high ? -1 : 1;
    boost::random::normal_distribution<double> normal(stream_.velocity[stream_.axis], back.thermal);
    do particle.velocity[stream_.axis] = normal(random);
    while (!(inward * particle.velocity[stream_.axis] > 0));
  }
  return true;
}

template class Backflow<2>;
template class Backflow<3>;

}  // namespace sandglass::event_driven
