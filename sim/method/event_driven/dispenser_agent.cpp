#include "sim/method/event_driven/dispenser_agent.hpp"

#include "sim/base/saved.hpp"
#include "sim/method/event_driven/books.hpp"
#include "sim/method/event_driven/bounce.hpp"
#include "sim/observe/axes.hpp"
#include "sim/physics/plane_flight.hpp"
#include "sim/space/flight.hpp"

#include <algorithm>
#include <cmath>

#include <boost/random/normal_distribution.hpp>

namespace sandglass::event_driven {

namespace {
constexpr int kAlong = 1;               ///< the axis of a side across x; the other one across y
constexpr double kTouching = 1e-9;      ///< of a radius; the piston jumps by a diameter at least
constexpr std::uint64_t kLostOne = 20;  ///< one in so many, where the fault is planted
}  // namespace

template <int D>
DispenserAgent<D>::DispenserAgent(const SidePlace& place, const Layer<D>& layer, const WallRule& piston,
                                  const Parameters<D>& parameters, const Streams& streams,
                                  WallImpulses<D>* impulses)
    : place_(place),
      layer_(layer),
      piston_(piston),
      traits_(parameters.species[layer.species]),
      gravity_(inward() * parameters.gravity[place.axis]),
      speed_(inward() * layer.velocity[place.axis]),
      length_(parameters.geometry.box[kAlong - place.axis]),
      round_(parameters.geometry.periodic[static_cast<std::size_t>(kAlong - place.axis)]),
      reach_(layer.width + parameters.largest_diameter() / 2),
      faults_(parameters.faults),
      streams_(streams),
      impulses_(impulses) {}

template <int D>
Box<D> DispenserAgent<D>::reach() const {
  Box<D> box = Box<D>::everywhere();
  const double far = place_.edge + inward() * reach_;
  box.low[place_.axis] = std::min(place_.edge, far);
  box.high[place_.axis] = std::max(place_.edge, far);
  return box;
}

/// Time since it began its way; the way of before it jumped goes on backwards, so that every look gives the same answer.
template <int D>
double DispenserAgent<D>::piston_at(double now) const {
  const double stroke = faults_.staying_piston ? 0 : static_cast<double>(layers_) * layer_.width;
  return speed_ * now - stroke;
}

template <int D>
double DispenserAgent<D>::height(const ParticleState<D>& particle, double now) const {
  return inward() * (particle.position[place_.axis] - place_.edge) - particle.radius - piston_at(now);
}

template <int D>
double DispenserAgent<D>::delay(const ParticleState<D>& particle, double now) const {
  const double h = height(particle, now);
  if (h < -particle.radius) return HUGE_VAL;  // behind it, where nobody is unless a fault is planted
  return time_to_fall({std::fabs(h) <= kTouching * particle.radius ? 0 : h,
                       inward() * particle.velocity[place_.axis] - speed_, gravity_});
}

template <int D>
Outcome DispenserAgent<D>::act(ParticleState<D>& particle, double now, Random& random) {
  if (height(particle, now) > kTouching * particle.radius) return Outcome::unchanged;
  const Vector<D> normal = inward() * Vector<D>::Unit(place_.axis), surface = speed_ * normal;
  const Vector<D> before = particle.velocity;
  const double energy = energy_beside(surface, at_wall(particle));
  bounce<D>(piston_, normal, surface, particle, random);
  if (impulses_ != nullptr)
    impulses_->add(place_.number(), particle.mass * (before - particle.velocity), surface,
                   energy - energy_beside(surface, at_wall(particle)));
  return Outcome::changed;
}

template <int D>
double DispenserAgent<D>::next() const {
  return speed_ > 0 ? static_cast<double>(layers_ + 1) * layer_.width / speed_ : HUGE_VAL;
}

template <int D>
void DispenserAgent<D>::act(ParticleAccess<D>& particles, double) {
  const StreamKey key(streams_.seed, Purpose::inflow, streams_.replica, layer_.stream);
  Random random(key, layers_++);
  for (const double along : row(random)) let_in(particles, newcomer(along, random));
}

/// Hard rods on a line, every arrangement alike: points at random in what the rods leave free, then the rods between them.
template <int D>
std::vector<double> DispenserAgent<D>::row(Random& random) const {
  const double diameter = traits_.diameter;
  std::vector<double> places(static_cast<std::size_t>(layer_.count));
  for (double& place : places) place = (length_ - layer_.count * diameter) * random.uniform();
  std::ranges::sort(places);
  const double turn = round_ ? length_ * random.uniform() : 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] += (static_cast<double>(i) + 0.5) * diameter + turn;
    if (round_) places[i] = wrap(places[i], length_, 1 / length_);
  }
  return places;
}

template <int D>
Newcomer<D> DispenserAgent<D>::newcomer(double along, Random& random) const {
  boost::random::normal_distribution<double> normal;
  Newcomer<D> newcomer{Vector<D>::Zero(), layer_.velocity};
  newcomer.species = layer_.species;
  newcomer.position[kAlong - place_.axis] = along;
  newcomer.position[place_.axis] =
      place_.edge + inward() * (traits_.diameter / 2 + (layer_.width - traits_.diameter) * random.uniform());
  for (double& component : newcomer.velocity.reshaped())
    component += std::sqrt(layer_.temperature / traits_.mass) * normal(random);
  if (layer_.spin_temperature > 0)
    for (double& component : newcomer.spin.reshaped())
      component = std::sqrt(layer_.spin_temperature / traits_.inertia) * normal(random);
  return newcomer;
}

/// The strip is empty unless a fault is planted; nobody is laid over another one.
template <int D>
void DispenserAgent<D>::let_in(ParticleAccess<D>& particles, const Newcomer<D>& newcomer) {
  if (faults_.staying_piston && !particles.has_room(newcomer.position, newcomer.species)) return;
  note_newcomer(impulses_, place_.number(), traits_, newcomer);
  if (entered_++ % kLostOne == 0 && faults_.lost_newcomers) return;
  particles.insert(newcomer);
}

template <int D>
void DispenserAgent<D>::count(std::map<std::string, double>& counters) const {
  counters["particles-entered"] += static_cast<double>(entered_);
  counters["particles-entered-" + side_name(place_.axis, place_.high)] = static_cast<double>(entered_);
}

template <int D>
std::vector<double> DispenserAgent<D>::save() const {
  return {static_cast<double>(layers_), static_cast<double>(entered_)};
}

template <int D>
void DispenserAgent<D>::load(const std::vector<double>& state) {
  layers_ = saved_count(state.at(0));
  entered_ = saved_count(state.at(1));
}

template class DispenserAgent<2>;

}  // namespace sandglass::event_driven
