#include "sim/method/event_driven/wall_agent.hpp"

#include "sim/method/event_driven/bounce.hpp"

namespace sandglass::event_driven {

template <int D>
WallAgent<D>::WallAgent(const WallPlace<D>& place, const WallRule& rule, const Vector<D>& gravity,
                        WallImpulses<D>* impulses)
    : place_(place),
      rule_(rule),
      inward_(place.high ? -1 : 1),
      gravity_(inward_ * gravity[place.axis]),
      motion_{0, inward_ * place.velocity[place.axis], place.amplitude, place.frequency,
              place.high ? M_PI : 0},
      impulses_(impulses) {}

template <int D>
Box<D> WallAgent<D>::reach() const {
  Box<D> box = Box<D>::everywhere();
  if (motion_.speed != 0) return box;
  const double swing = std::fabs(motion_.amplitude) + place_.largest_radius;
  box.low[place_.axis] = place_.edge - swing;
  box.high[place_.axis] = place_.edge + swing;
  return box;
}

template <int D>
double WallAgent<D>::delay(const ParticleState<D>& particle, double now) const {
  const double x = particle.position[place_.axis], height = inward_ * (x - place_.edge) - particle.radius;
  // A ball that bounces ever lower would take the last digits of its place for a height to fall from.
  const double rounding = 4e-16 * (std::fabs(x) + std::fabs(place_.edge) + particle.radius);
  const Arc arc{std::fabs(height) <= rounding ? 0 : height, inward_ * particle.velocity[place_.axis],
                gravity_};
  return motion_.speed == 0 && !motion_.vibrates() ? time_to_fall(arc)
                                                   : time_to_plane(arc, motion_.from(now));
}

template <int D>
Outcome WallAgent<D>::act(ParticleState<D>& particle, double now, Random& random) {
  const Vector<D> normal = inward_ * Vector<D>::Unit(place_.axis);
  Vector<D> surface = place_.velocity;
  surface[place_.axis] = inward_ * motion_.velocity_at(now);
  const Vector<D> before = particle.velocity;
  const double energy = impulses_ != nullptr ? energy_beside(surface, at_wall(particle)) : 0;
  bounce<D>(rule_, normal, surface, particle, random);
  if (impulses_ != nullptr)
    impulses_->add(WallImpulses<D>::side(place_.axis, place_.high),
                   particle.mass * (before - particle.velocity), surface,
                   energy - energy_beside(surface, at_wall(particle)));
  return Outcome::changed;
}

template class WallAgent<2>;
template class WallAgent<3>;

}  // namespace sandglass::event_driven
