#pragma once

#include "sim/base/random.hpp"
#include "sim/base/vector.hpp"

#include <cmath>

namespace sandglass {

/// Smooth inelastic spheres or disks of equal mass. The impulse on particle 1 is -(1 + r)/2 m (c . n) n, with
/// c = v1 - v2 and n the unit vector from particle 2 to particle 1 (Baryshev 2003, Eq. 3.57).
struct SmoothInelastic {
  double restitution;

  template <int D>
  void operator()(Vector<D>& velocity_1, Vector<D>& velocity_2, const Vector<D>& normal) const {
    const double kick = -0.5 * (1 + restitution) * (velocity_1 - velocity_2).dot(normal);
    velocity_1 += kick * normal;
    velocity_2 -= kick * normal;
  }
};

/// Direction from particle 2 to particle 1 at contact when their relative velocity v1 - v2 is `relative` and the impact
/// parameter is `impact` diameters, uniform over the cross-section (molecular chaos).
inline Vector<2> contact_normal(const Vector<2>& relative, double inverse_speed, const Vector<1>& impact) {
  const double along = -std::sqrt(1 - impact.squaredNorm()) * inverse_speed;
  const double across = impact[0] * inverse_speed;
  return {along * relative[0] - across * relative[1], along * relative[1] + across * relative[0]};
}

/// As above on spheres: `impact` is a point of the unit disk across the relative velocity.
inline Vector<3> contact_normal(const Vector<3>& relative, double inverse_speed, const Vector<2>& impact) {
  const Vector<3> direction = relative * inverse_speed;
  // Orthonormal basis without trigonometry or branches (Duff et al. 2017).
  const double sign = std::copysign(1.0, direction[2]);
  const double a = -1 / (sign + direction[2]);
  const double b = direction[0] * direction[1] * a;
  const Vector<3> first(1 + sign * direction[0] * direction[0] * a, sign * b, -sign * direction[0]);
  const Vector<3> second(b, sign + direction[1] * direction[1] * a, -direction[1]);
  return impact[0] * first + impact[1] * second - std::sqrt(1 - impact.squaredNorm()) * direction;
}

/// Two signed coordinates in (-1, 1), 32 bits each, from one draw.
inline Vector<2> uniform_square(Random& random) {
  const std::uint64_t bits = random.bits();
  const auto low = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
  const auto high = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 32));
  return {(low + 0.5) * 0x1p-31, (high + 0.5) * 0x1p-31};
}

/// Uniform on the cross-section, in diameters: an interval in 2D, a disk in 3D.
template <int D>
Vector<D - 1> uniform_impact(Random& random) {
  if constexpr (D == 2) {
    return Vector<1>(2 * random.uniform() - 1);
  } else {
    Vector<2> point;
    do point = uniform_square(random);
    while (point.squaredNorm() >= 1);
    return point;
  }
}

/// Uniform on the unit circle or sphere (Marsaglia 1972).
template <int D>
[[gnu::always_inline]] inline Vector<D> uniform_direction(Random& random) {
  const Vector<2> point = uniform_impact<3>(random);
  const double square = point.squaredNorm();
  if constexpr (D == 2) {
    // Doubling the angle of a point of the disk needs no root.
    return Vector<2>(point[0] * point[0] - point[1] * point[1], 2 * point[0] * point[1]) / square;
  } else {
    const double across = 2 * std::sqrt(1 - square);
    return Vector<3>(across * point[0], across * point[1], 1 - 2 * square);
  }
}

/// Change of the velocity of particle 1 (particle 2 gets the opposite) in a smooth collision of equal masses with a uniform
/// impact parameter. Without the normal, its root and its division: in 3D the elastic relative velocity leaves in a
/// uniform direction e, so that the kick is (1 + r)/4 (|c| e - c). The slow twin is contact_normal with SmoothInelastic.
[[gnu::always_inline]] inline Vector<3> smooth_kick(const Vector<3>& relative, double square_speed,
                                                    double restitution, Random& random) {
  const Vector<3> leaving = std::sqrt(square_speed) * uniform_direction<3>(random);
  return 0.25 * (1 + restitution) * (leaving - relative);
}

/// In 2D the kick is -(1 + r)/2 ((1 - b^2) c + b sqrt(1 - b^2) c_perp) with the impact parameter b in diameters.
[[gnu::always_inline]] inline Vector<2> smooth_kick(const Vector<2>& relative, double, double restitution,
                                                    Random& random) {
  const double b = uniform_impact<2>(random)[0];
  const double along = 1 - b * b, across = b * std::sqrt(along);
  return -0.5 * (1 + restitution) *
         Vector<2>(along * relative[0] - across * relative[1], along * relative[1] + across * relative[0]);
}

/// Total cross-section of particles of one diameter: 2 d in 2D, pi d^2 in 3D.
inline double cross_section(int dimension, double diameter) {
  return dimension == 2 ? 2 * diameter : M_PI * diameter * diameter;
}

}  // namespace sandglass
