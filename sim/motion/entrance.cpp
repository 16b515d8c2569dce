#include "sim/motion/entrance.hpp"

#include "sim/motion/stream_index.hpp"

#include <limits>

namespace sandglass::motion {

namespace {
/// No cell has this number: the draws of entrants at walls are those of nobody else.
constexpr std::uint32_t kOutside = std::numeric_limits<std::uint32_t>::max();
}  // namespace

template <int D>
Arrived<D> Entrance<D>::fly(const Entrants<D>& entrants, const MotionStep& step) const {
  Arrived<D> arrived;
  Particles<D> flying = entrants.particles;
  const Bodies<D> bodies(surfaces_.parameters, flying.columns.get(column::species).data(),
                         flying.columns.edit(column::spin<D>).data());
  const FlightCounters<D> counters{surfaces_.parameters.planes, surfaces_.parameters.impulses};
  std::vector<std::uint32_t> inside;
  for (std::uint32_t i = 0; i < flying.phases.size(); ++i) {
    const Arrival& arrival = entrants.arrivals[i];
    Phase<D>& particle = flying.phases[i];
    count(particle, arrival, bodies[i]);
    Random random(step.key, stream_index(kOutside, i));
    const MotionStep rest{arrival.left, step.time + step.dt - arrival.left, step.key};
    BoundedFlight<D>(surfaces_, box_, rest).fly(particle, bodies[i], random, counters);
    if (surfaces_.has_left(particle.position))
      arrived.left.push_back(particle.position);
    else
      inside.push_back(i);
  }
  arrived.particles = pick(flying, inside);
  return arrived;
}

/// What comes in takes from the side what going out gives it.
template <int D>
void Entrance<D>::count(const Phase<D>& particle, const Arrival& arrival, const Body<D>& body) const {
  if (surfaces_.parameters.impulses == nullptr) return;
  surfaces_.parameters.impulses->add(WallImpulses<D>::side(arrival.axis, arrival.high),
                                     -body.mass * particle.velocity, Vector<D>::Zero(),
                                     -energy_of(particle.velocity, body));
}

template class Entrance<2>;
template class Entrance<3>;

}  // namespace sandglass::motion
