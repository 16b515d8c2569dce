#pragma once

#include "sim/method/dsmc/pair_rule.hpp"

namespace sandglass::dsmc {

/// A pair rule says what the collision kernel must know of two particles: how often they collide, and what a collision
/// does to them. This one: smooth particles of one species. Another rule (MixedPairs, RoughPairs) is a class with the same
/// members and a line in collision_stage.cpp; all the rest of the kernel is shared.
template <int D>
class SmoothPairs : public PairRule<D> {
 public:
  /// Columns that the rule reads and changes, from the first particle of a cell on.
  struct Columns {
    Phase<D>* phases;
  };

  explicit SmoothPairs(const Parameters& parameters)
      : restitution_(parameters.restitution), mass_(parameters.mass) {}

  Columns columns(const CollisionStep<D>& step, std::uint32_t cell) const {
    return {step.particles + step.offsets[cell]};
  }

  /// What candidates are drawn for: at least relative speed times cross-section of any pair among `count` particles of a
  /// cell, in units of that of CollisionStep::coefficient, where no relative speed is above `speed`.
  double bound(const Columns&, std::uint32_t, double speed) const { return speed; }
  /// Whether a candidate collides: with probability |c| sigma_12 over the bound.
  bool accepts(const Columns&, const Pair&, double square_speed, double square_bound, double uniform) const {
    return uniform * uniform * square_bound < square_speed;
  }
  /// Speed times cross-section of a pair, in the units of bound().
  double rate(const Columns&, const Pair&, double speed) const { return speed; }
  /// Changes both particles and returns the change of the first velocity along the line of centres. `relative` is
  /// v_1 - v_2.
  Vector<D> collide(const Columns& columns, const Pair& pair, const Vector<D>& relative, double square_speed,
                    Random& random) const {
    const Vector<D> change = smooth_kick(relative, square_speed, restitution_, random);
    columns.phases[pair.first].velocity += change;
    columns.phases[pair.second].velocity -= change;
    return change;
  }
  /// The same with a given line of centres, from the second to the first.
  Vector<D> strike(const Columns& columns, const Pair& pair, const Vector<D>& normal) const {
    Vector<D>& velocity = columns.phases[pair.first].velocity;
    const Vector<D> before = velocity;
    SmoothInelastic{restitution_}(velocity, columns.phases[pair.second].velocity, normal);
    return velocity - before;
  }
  /// Sum over both partners of m v' . displacement where displace() moves them.
  double transfer(const Columns& columns, const Pair& pair, const Vector<D>& shift) const {
    const Phase<D>&one = columns.phases[pair.first], &two = columns.phases[pair.second];
    return mass_ * (one.velocity - two.velocity).dot(shift);
  }

 private:
  double restitution_, mass_;
};

}  // namespace sandglass::dsmc
