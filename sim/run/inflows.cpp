#include "sim/run/inflows.hpp"

#include "sim/base/error.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/observe/axes.hpp"
#include "sim/physics/flux_sampler.hpp"

#include <cmath>

#include <boost/random/normal_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double kMostInAStep = 1e6;

/// A planted fault: normal velocities are Maxwell's own, those of the right sign.
double maxwellian_inwards(double stream, double thermal, Random& random) {
  boost::random::normal_distribution<double> normal(stream, thermal);
  return std::abs(normal(random));
}

template <int D>
Spin<D> draw_spin(double width, Random& random) {
  boost::random::normal_distribution<double> normal;
  Spin<D> spin;
  for (double& component : spin.reshaped()) component = width * normal(random);
  return spin;
}
}  // namespace

template <int D>
Inflows<D>::Inflows(const Setup<D>& setup, const Streams& streams)
    : setup_(setup), streams_(streams), room_(setup.scene), entered_(setup.inflows.size()) {
  for (const Inflow& inflow : setup.inflows) {
    const double rate = inflow_rate(setup.scene, inflow);
    if (setup.weights) sides_.push_back(setup.weights->along(inflow.axis, inflow.high));
    rate_.push_back(setup.weights ? rate * setup.scene.method.weight * sides_.back().mean_inverse : rate);
  }
}

template <int D>
void Inflows<D>::enter(Simulator<D>& simulator, const Clock& clock, double dt, double end) {
  Entrants<D> entrants;
  for (std::size_t i = 0; i < rate_.size(); ++i) {
    if (setup_.inflows[i].entry != InflowEntry::flux) continue;
    const double count = due(i, clock, dt, end);
    if (!(count > 0)) continue;
    if (count > kMostInAStep)
      throw RunError(
          fmt::format("step {}: {} particles are to come in by an [[inflow]] in one step; at most {} are "
                      "allowed: shorten 'method.time-step' or raise 'method.weight'",
                      clock.step, count, kMostInAStep));
    draw(i, count, dt, entrants);
    entered_[i] += setup_.inflows[i].fault == InflowFault::off_by_one ? count - 1 : count;
  }
  if (!entrants.arrivals.empty()) simulator.enter(entrants, dt, clock.step);
}

template <int D>
double Inflows<D>::due(std::size_t index, const Clock& clock, double dt, double end) const {
  const Inflow& inflow = setup_.inflows[index];
  if (inflow.fault == InflowFault::remainder_dropped) return std::floor(rate_[index] * dt);
  if (inflow.arrivals == Arrivals::even) return std::floor(rate_[index] * end) - entered_[index];
  const double expected = rate_[index] * dt;
  if (expected > kMostInAStep) return expected;  // to be refused
  Random random({streams_.seed, Purpose::arrivals, streams_.replica, clock.step}, index);
  return static_cast<double>(boost::random::poisson_distribution<std::int64_t>(expected)(random));
}

template <int D>
void Inflows<D>::draw(std::size_t index, double count, double dt, Entrants<D>& entrants) const {
  const Inflow& inflow = setup_.inflows[index];
  const SpeciesTraits kind = traits_of(setup_.scene)[inflow.species];
  const double thermal = std::sqrt(inflow.temperature / kind.mass);
  const double spin = std::sqrt(inflow.spin_temperature / kind.inertia);
  const Vector<D> stream = vector_of<D>(inflow.velocity);
  Vector<D> low;
  for (int axis = 0; axis < D; ++axis) low[axis] = room_.margin(axis, kind.diameter / 2);
  const Vector<D> width = room_.box - 2 * low;
  const double inward = inflow.high ? -1 : 1;
  const StreamFlux<D> flux(stream, thermal, inflow.axis, inward);
  const StreamKey key(streams_.seed, Purpose::inflow, streams_.replica, index);
  const auto first = static_cast<std::uint64_t>(entered_[index]);
  for (std::uint64_t n = first; n < first + static_cast<std::uint64_t>(count); ++n) {
    Random random(key, n);
    Phase<D> particle;
    const auto draw_place = [&] {
      for (int axis = 0; axis < D; ++axis)
        particle.position[axis] = low[axis] + width[axis] * random.uniform();
      particle.position[inflow.axis] = inflow.high ? room_.box[inflow.axis] : 0;
    };
    draw_place();
    if (setup_.weights) {
      // Of the places, evenly spread over real particles, one in w over the lowest weight is that of a simulated one.
      double weight = setup_.weights->at(particle.position);
      for (; random.uniform() * weight >= sides_[index].lightest;
           weight = setup_.weights->at(particle.position))
        draw_place();
      entrants.particles.columns.append(column::weight, weight);
    }
    entrants.arrivals.push_back({inflow.axis, inflow.high, dt * (1 - random.uniform())});
    particle.velocity = flux(random);
    if (inflow.fault == InflowFault::maxwellian)
      particle.velocity[inflow.axis] =
          inward * maxwellian_inwards(inward * stream[inflow.axis], thermal, random);
    entrants.particles.phases.push_back(particle);
    if (setup_.scene.species.size() > 1)
      entrants.particles.columns.append(column::species, static_cast<std::uint8_t>(inflow.species));
    if (is_rough(setup_.scene))
      entrants.particles.columns.append(column::spin<D>, draw_spin<D>(spin, random));
  }
}

template <int D>
std::map<std::string, double> Inflows<D>::counters() const {
  std::map<std::string, double> counters;
  for (std::size_t i = 0; i < entered_.size(); ++i) {
    const Inflow& inflow = setup_.inflows[i];
    if (inflow.entry != InflowEntry::flux) continue;
    counters["particles-entered"] += entered_[i];
    counters["particles-entered-" + side_name(inflow.axis, inflow.high)] += entered_[i];
  }
  return counters;
}

template class Inflows<2>;
template class Inflows<3>;

}  // namespace sandglass
