#pragma once

#include "sim/method/event_driven/gas.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/physics/contact.hpp"

#include <algorithm>
#include <limits>

namespace sandglass::event_driven {

/// What a collision did.
template <int D>
struct Impact {
  Vector<D> impulse;  ///< on the first partner
  double approach;    ///< speed along the normal before
};

/// Rounding must not leave a pair that has collided on its way into each other: it would collide again at once, with
/// kicks too small to change anything. A push by the last digits.
template <int D>
void make_receding(const Vector<D>& normal, Vector<D>& velocity_1, Vector<D>& velocity_2) {
  const auto stays = [&] {
    const Vector<D> relative = velocity_1 - velocity_2;
    const double leaving = relative.dot(normal);
    return leaving < 0 || leaving * leaving < 1e-30 * relative.squaredNorm();
  };
  if (!stays()) [[likely]]
    return;
  double push = std::max(std::numeric_limits<double>::epsilon() * (velocity_1.norm() + velocity_2.norm()),
                         std::numeric_limits<double>::min());
  do {
    velocity_1 += push * normal;
    velocity_2 -= push * normal;
    push *= 2;
  } while (stays());
}

/// The collision rule of the scene, on the columns of the gas.
template <int D>
class CollisionRule {
 public:
  explicit CollisionRule(const Parameters<D>& parameters) : parameters_(parameters) {
    const Surface& only = parameters.surfaces.front();
    simple_ = parameters.species.size() == 1 && !parameters.rough && only.normal.reference_speed == 0;
    half_kick_ = 0.5 * (1 + only.normal.value);
  }

  /// Both partners stand where they touch; `normal` points from the second to the first. `now` is for the TC model.
  Impact<D> apply(Gas<D>& gas, std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double now,
                  std::uint64_t& guarded) const {
    Vector<D>& velocity_1 = gas.particles[first].velocity;
    Vector<D>& velocity_2 = gas.particles[second].velocity;
    const double approach = (velocity_2 - velocity_1).dot(normal);
    if (!simple_) return apply_general(gas, first, second, normal, approach, now, guarded);
    const double half_kick = is_guarded(gas, first, second, now, guarded) ? 1 : half_kick_;
    const Vector<D> kick = half_kick * std::max(approach, 0.0) * normal;
    velocity_1 += kick;
    velocity_2 -= kick;
    return {parameters_.species.front().mass * kick, approach};
  }

  /// Whether the TC model makes the next contact of a particle elastic (Luding & McNamara 1998), with whatever it is.
  bool guards(const Gas<D>& gas, std::uint32_t particle, double now) const {
    return !gas.last_contact.empty() && now - gas.last_contact[particle] < parameters_.contact_time;
  }
  /// Whether the TC model makes the contact of two particles elastic; counts that, and notes the contact.
  bool is_guarded(Gas<D>& gas, std::uint32_t first, std::uint32_t second, double now,
                  std::uint64_t& guarded) const {
    if (gas.last_contact.empty()) return false;
    const bool elastic = guards(gas, first, now) || guards(gas, second, now);
    guarded += elastic;
    set_last_contact(gas, first, now);
    set_last_contact(gas, second, now);
    return elastic;
  }
  /// For the TC model.
  void set_last_contact(Gas<D>& gas, std::uint32_t particle, double now) const {
    if (!gas.last_contact.empty()) gas.last_contact[particle] = now;
  }

 private:
  Impact<D> apply_general(Gas<D>& gas, std::uint32_t first, std::uint32_t second, const Vector<D>& normal,
                          double approach, double now, std::uint64_t& guarded) const;

  Parameters<D> parameters_;
  bool simple_;
  double half_kick_;
};

extern template class CollisionRule<2>;
extern template class CollisionRule<3>;

}  // namespace sandglass::event_driven
