#pragma once

#include "sim/method/event_driven/gas.hpp"
#include "sim/physics/contact.hpp"

namespace sandglass::event_driven {

/// What a collision did.
template <int D>
struct Impact {
  Vector<D> impulse;  ///< on the first partner
  double approach;    ///< speed along the normal before
};

/// The collision rule of the scene, on the columns of the gas.
template <int D>
class CollisionRule {
 public:
  explicit CollisionRule(const Parameters<D>& parameters) : parameters_(parameters) {
    const Surface& only = parameters.surfaces.front();
    simple_ = parameters.species.size() == 1 && !parameters.rough && !(parameters.contact_time > 0) &&
              only.normal.reference_speed == 0;
    half_kick_ = 0.5 * (1 + only.normal.value);
  }

  /// Both partners stand where they touch; `normal` points from the second to the first. `now` is for the TC model.
  Impact<D> apply(Gas<D>& gas, std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double now,
                  std::uint64_t& guarded) const {
    Vector<D>& velocity_1 = gas.bodies[first].velocity;
    Vector<D>& velocity_2 = gas.bodies[second].velocity;
    const double approach = (velocity_2 - velocity_1).dot(normal);
    if (!simple_) return apply_general(gas, first, second, normal, approach, now, guarded);
    const Vector<D> kick = half_kick_ * approach * normal;
    velocity_1 += kick;
    velocity_2 -= (1 - parameters_.faults.momentum_leak) * kick;
    return {parameters_.species.front().mass * kick, approach};
  }

 private:
  Impact<D> apply_general(Gas<D>& gas, std::uint32_t first, std::uint32_t second, const Vector<D>& normal,
                          double approach, double now, std::uint64_t& guarded) const;
  /// Whether the TC model makes the collision elastic (Luding & McNamara 1998).
  bool guards(Gas<D>& gas, std::uint32_t first, std::uint32_t second, double now) const;

  Parameters<D> parameters_;
  bool simple_;
  double half_kick_;
};

extern template class CollisionRule<2>;
extern template class CollisionRule<3>;

}  // namespace sandglass::event_driven
