#pragma once

#include "sim/base/error.hpp"
#include "sim/motion/free_flight.hpp"
#include "sim/motion/parameters.hpp"
#include "sim/motion/passages.hpp"
#include "sim/space/cell_locator.hpp"
#include "sim/space/flight.hpp"
#include "sim/space/particle_store.hpp"

namespace sandglass::motion {

enum class Walls { none, specular };

template <int D>
[[gnu::always_inline]] inline void require_finite(const Phase<D>& particle) {
  if (!particle.position.allFinite() || !particle.velocity.allFinite())
    throw RunError(
        "a position or velocity is not a finite number: time step too long, or too strong a force?");
}

/// The flight of one step in a periodic box or between smooth elastic walls at rest, without obstacles.
template <int D, bool Gravity, Walls Sides>
class PlainFlight {
 public:
  static constexpr int kDimension = D;
  using Surroundings = MotionParameters<D>;
  template <class InBox>
  using Locator = InBox;
  using Lane = Lanes<D>;

  PlainFlight(const Surroundings& parameters, const ParticleStore<D>& store, const MotionStep& step)
      : parameters_(parameters),
        box_(store.grid().box()),
        dt_(step.dt),
        flight_(parameters.gravity, box_, step.dt) {}

  /// Free flight where it stays in the box, which is nearly always; else axis by axis with the boundaries. The answer is
  /// where it ends; planes and walls count if `Counts`.
  template <bool Counts>
  [[gnu::always_inline]] typename Lane::Real fly(Phase<D>& particle, std::size_t) const {
    typename Lane::Real end;
    if (is_free(particle, end)) [[likely]]
      return fly_free<Counts>(particle, end);
    if constexpr (Counts) count_crossings(particle);
    return fly_bounded(parameters_, box_, dt_, Counts ? parameters_.impulses : nullptr, particle);
  }

  /// Whether the path meets no boundary; then `end` is where it ends.
  [[gnu::always_inline]] bool is_free(const Phase<D>& particle, typename Lane::Real& end) const {
    const double* components = particle.position.data();
    const typename Lane::Real start = Lane::load(components), velocity = Lane::load(components + D);
    end = flight_.template end<Gravity>(start, velocity);
    return stays(start, velocity, end);
  }
  /// fly() to the end that is_free() gave.
  template <bool Counts>
  [[gnu::always_inline]] typename Lane::Real fly_free(Phase<D>& particle,
                                                      const typename Lane::Real& end) const {
    if constexpr (Counts) count_crossings(particle);
    double* components = particle.position.data();
    Lane::store(components, end);
    if constexpr (Gravity) Lane::store(components + D, Lane::load(components + D) + flight_.gain());
    return end;
  }
  /// Where a particle counts that ends its flight here.
  static const typename Lane::Real& in_box(const typename Lane::Real& end) { return end; }

  /// Where fly() would end. A path that meets boundaries is flown in `arrived`, and `bounded` set.
  typename Lane::Real look(const Phase<D>& particle, std::size_t, Phase<D>& arrived, bool& bounded) const {
    typename Lane::Real end;
    if (is_free(particle, end)) return end;
    arrived = particle;
    bounded = true;
    return fly_bounded(parameters_, box_, dt_, nullptr, arrived);
  }

 private:
  /// The whole path is inside the box.
  [[gnu::always_inline]] bool stays(const typename Lane::Real& start, const typename Lane::Real& velocity,
                                    const typename Lane::Real& position) const {
    bool stays = flight_.inside(position);
    if constexpr (Sides == Walls::specular) {
      // Gravity bends the path away from its tangent and no further than the chord from start to end.
      if constexpr (Gravity) stays = stays && flight_.inside(flight_.template end<false>(start, velocity));
      if (parameters_.offsets) stays = stays && flight_.inside(start);
    }
    return stays;
  }

  // Static: an object that no function sees stays in registers.
  [[gnu::noinline]] static typename Lane::Real fly_bounded(const Surroundings& parameters,
                                                           const Vector<D>& box, double dt,
                                                           WallImpulses<D>* impulses, Phase<D>& particle) {
    for (int axis = 0; axis < D; ++axis) fly_along(parameters, axis, box[axis], dt, impulses, particle);
    require_finite(particle);  // what is not a number is never inside the box: it always comes by here
    return Lane::from(particle.position, 0);
  }

  static void fly_along(const Surroundings& parameters, int axis, double length, double dt,
                        WallImpulses<D>* impulses, Phase<D>& particle) {
    double& x = particle.position[axis];
    double& velocity = particle.velocity[axis];
    if constexpr (Sides == Walls::specular) {
      if (parameters.walled[static_cast<std::size_t>(axis)]) {
        if (parameters.offsets) x = mirror(x, length);
        HitSpeeds hits;
        HitSpeeds* counts = impulses != nullptr ? &hits : nullptr;
        if (Gravity && parameters.gravity[axis] != 0)
          fall_between_walls(x, velocity, parameters.gravity[axis], dt, length, counts);
        else
          fly_between_walls(x, velocity, dt, length, counts);
        if (counts != nullptr) give(hits, axis, parameters.mass, *impulses);
        return;
      }
    }
    x += dt * (velocity + 0.5 * dt * parameters.gravity[axis]);
    velocity += dt * parameters.gravity[axis];
    x = wrap(x, length, 1 / length);
  }

  /// A smooth elastic wall at rest takes twice the momentum that comes.
  static void give(const HitSpeeds& hits, int axis, double mass, WallImpulses<D>& impulses) {
    const Vector<D> still = Vector<D>::Zero(), along = 2 * mass * Vector<D>::Unit(axis);
    if (hits.low > 0) impulses.add(WallImpulses<D>::side(axis, false), -hits.low * along, still, 0);
    if (hits.high > 0) impulses.add(WallImpulses<D>::side(axis, true), hits.high * along, still, 0);
  }

  /// Planes are normal to periodic axes: the passages are those of the unwrapped path.
  [[gnu::always_inline]] void count_crossings(const Phase<D>& particle) const {
    if (parameters_.planes == nullptr) return;
    for (Plane& plane : *parameters_.planes) {
      const double length = box_[plane.axis()], velocity = particle.velocity[plane.axis()];
      if constexpr (Gravity) {
        if (const double pull = parameters_.gravity[plane.axis()]; pull != 0) {
          const Arc arc{particle.position[plane.axis()], velocity, pull};
          count_passages(plane, length, arc, dt_, arc.at(dt_));
          continue;
        }
      }
      const double before = wrap(particle.position[plane.axis()], length, 1 / length) - plane.position();
      const double after = before + velocity * dt_;
      if ((before < 0) == (after < 0) && std::abs(after) < length) [[likely]]
        continue;
      const double passages = std::floor(after / length) - std::floor(before / length);
      for (int i = 0; i < std::abs(static_cast<int>(passages)); ++i) plane.count(velocity);
    }
  }

  const MotionParameters<D>& parameters_;
  const Vector<D>& box_;
  double dt_;
  FreeFlight<D> flight_;
};

}  // namespace sandglass::motion
