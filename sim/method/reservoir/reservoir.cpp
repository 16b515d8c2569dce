#include "sim/method/reservoir/reservoir.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>

namespace sandglass::reservoir {

template <int D>
Reservoir<D>::Reservoir(const Parameters& parameters, const Streams& streams, std::vector<Plane>* planes)
    : parameters_(parameters), streams_(streams), planes_(planes) {}

template <int D>
void Reservoir<D>::step(double dt, std::uint64_t step) {
  const StreamKey key(streams_.seed, Purpose::crossings, streams_.replica, step);
  cross(dt, 1, Random(key, 0));
  cross(dt, -1, Random(key, 1));
}

template <int D>
void Reservoir<D>::cross(double dt, double direction, Random random) {
  const FluxSampler sampler(direction * parameters_.stream, parameters_.thermal);
  const double rate = parameters_.faults.net_rate ? std::abs(parameters_.stream) : sampler.rate();
  const double expected = parameters_.number_density * parameters_.area * rate * dt;
  boost::random::normal_distribution<double> maxwellian(direction * parameters_.stream, parameters_.thermal);
  const std::int64_t crossings = boost::random::poisson_distribution<std::int64_t>(expected)(random);
  for (std::int64_t i = 0; i < crossings; ++i) {
    const double velocity = parameters_.faults.maxwellian ? std::abs(maxwellian(random)) : sampler(random);
    for (Plane& plane : *planes_) plane.count(direction * velocity);
  }
  tally_.moves += static_cast<std::uint64_t>(crossings);
}

template <int D>
View<D> Reservoir<D>::view() {
  View<D> view;
  view.tally = &tally_;
  view.planes = planes_;
  return view;
}

template class Reservoir<2>;
template class Reservoir<3>;

}  // namespace sandglass::reservoir
