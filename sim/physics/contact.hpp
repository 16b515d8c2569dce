#pragma once

#include "sim/base/error.hpp"
#include "sim/base/vector.hpp"
#include "sim/physics/restitution.hpp"

#include <limits>

namespace sandglass {

/// How two surfaces collide (Baryshev 2003, Eq. 3.49-3.69).
struct Surface {
  Restitution normal;
  /// Tangential restitution in [-1, 1]: the tangential velocity of the contact becomes -e_t times what it was. -1 smooth,
  /// 0 fully rough, 1 perfectly rough and energy conserving. Kawasaki (1986): eps_s = -e_t.
  double tangential = -1;
  /// Coulomb's coefficient: the contact slides when the tangential impulse would exceed it times the normal impulse.
  double friction = std::numeric_limits<double>::infinity();

  bool smooth() const { return tangential == -1 || friction == 0; }
};

/// What a pair of two species takes: the arithmetic mean of each coefficient.
inline Surface mix(const Surface& a, const Surface& b) {
  return {{(a.normal.value + b.normal.value) / 2, (a.normal.reference_speed + b.normal.reference_speed) / 2},
          (a.tangential + b.tangential) / 2,
          (a.friction + b.friction) / 2};
}

/// One side of a contact, wherever its state is kept. A wall or a fixed obstacle has inverse mass and inverse inertia 0;
/// its velocity is that of its surface.
template <int D>
struct Partner {
  Vector<D>& velocity;
  Spin<D>& spin;
  double inverse_mass, inverse_inertia, radius;
};

/// w x n: velocity per radius that a spin gives to the surface at n.
inline Vector<2> swept(const Spin<2>& spin, const Vector<2>& n) { return {-spin[0] * n[1], spin[0] * n[0]}; }
inline Vector<3> swept(const Spin<3>& w, const Vector<3>& n) {
  return {w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2], w[0] * n[1] - w[1] * n[0]};
}

/// n x J: change of angular momentum per radius by an impulse at n.
inline Spin<2> torque(const Vector<2>& n, const Vector<2>& impulse) {
  return Spin<2>(n[0] * impulse[1] - n[1] * impulse[0]);
}
inline Spin<3> torque(const Vector<3>& n, const Vector<3>& impulse) { return swept(n, impulse); }

/// Velocity of the first surface relative to the second where they touch (Baryshev 2003, Eq. 3.53).
template <int D>
Vector<D> contact_velocity(const Vector<D>& normal, const Partner<D>& first, const Partner<D>& second) {
  return first.velocity - second.velocity -
         swept(first.radius * first.spin + second.radius * second.spin, normal);
}

/// Mass that a tangential impulse moves; M q / (1 + q) for two particles of inertia q m R^2 and reduced mass M.
template <int D>
double tangential_mass(const Partner<D>& first, const Partner<D>& second) {
  return 1 / (first.inverse_mass + second.inverse_mass + first.inverse_inertia * first.radius * first.radius +
              second.inverse_inertia * second.radius * second.radius);
}

/// Impulse along the surface on the first partner: it sticks, or slides where that would take more than Coulomb's
/// friction. `slip` is the tangential part of the contact velocity.
template <int D>
Vector<D> tangential_impulse(const Surface& surface, const Vector<D>& slip, double mass,
                             double normal_impulse) {
  const Vector<D> sticking = -(1 + surface.tangential) * mass * slip;
  const double size = sticking.norm();
  // Infinite friction times no impulse is no number: it compares false, and sticks.
  const double most = surface.friction * normal_impulse;
  return size > most ? Vector<D>(sticking * (most / size)) : sticking;
}

/// The collision of two partners of any mass, radius and inertia, with spin. `normal` is the unit vector from the second
/// to the first. A receding pair is left alone (Bannerman et al. 2014) and the answer is false.
template <int D>
bool collide(const Surface& surface, const Vector<D>& normal, const Partner<D>& first,
             const Partner<D>& second) {
  SANDGLASS_EXPECT(first.inverse_mass + second.inverse_mass > 0);
  const double approach = (second.velocity - first.velocity).dot(normal);
  if (!(approach > 0)) return false;
  const double normal_impulse =
      (1 + surface.normal(approach)) * approach / (first.inverse_mass + second.inverse_mass);
  Vector<D> impulse = normal_impulse * normal;
  if (!surface.smooth()) {
    const Vector<D> contact = contact_velocity(normal, first, second);
    const Vector<D> slip = contact - contact.dot(normal) * normal;
    impulse += tangential_impulse<D>(surface, slip, tangential_mass(first, second), normal_impulse);
    const Spin<D> turn = torque(normal, impulse);
    first.spin -= first.inverse_inertia * first.radius * turn;
    second.spin -= second.inverse_inertia * second.radius * turn;
  }
  first.velocity += first.inverse_mass * impulse;
  second.velocity -= second.inverse_mass * impulse;
  return true;
}

/// Tangential restitution that sliding amounts to (Baryshev 2003, Eq. 3.68, for any masses): the effective value is the
/// lesser of this and the one that sticks. `masses` is reduced mass over tangential mass, 1 + 1/q for equal kinds, and
/// `approach` and `slip` are the speeds of the contact along and across the normal, slip > 0.
inline double sliding_restitution(const Surface& surface, double approach, double slip, double masses) {
  return -1 + surface.friction * (1 + surface.normal(approach)) * masses * approach / slip;
}

/// Impulse on particle 1 in a smooth collision (Baryshev 2003, Eq. 3.57); `relative` is v1 - v2, `normal` the unit vector
/// from 2 to 1. Both masses are finite.
template <int D>
[[gnu::always_inline]] inline Vector<D> smooth_impulse(double mass_1, double mass_2, double restitution,
                                                       const Vector<D>& relative, const Vector<D>& normal) {
  return -(1 + restitution) * (mass_1 * mass_2 / (mass_1 + mass_2)) * relative.dot(normal) * normal;
}

}  // namespace sandglass
