#pragma once

#include "sim/base/random.hpp"
#include "sim/physics/contact.hpp"

namespace sandglass {

template <int D>
struct Ball {
  Vector<D> velocity;
  Spin<D> spin;
  double mass, radius, inertia;

  Partner<D> partner() { return {velocity, spin, 1 / mass, 1 / inertia, radius}; }
  double energy() const { return 0.5 * mass * velocity.squaredNorm() + 0.5 * inertia * spin.squaredNorm(); }
};

template <class Column>
Column any(Random& random) {
  Column column;
  for (double& entry : column.reshaped()) entry = 4 * random.uniform() - 2;
  return column;
}

template <int D>
struct Pair {
  Ball<D> first, second;
  Vector<D> normal;

  bool collide(const Surface& surface) {
    return sandglass::collide(surface, normal, first.partner(), second.partner());
  }
  double energy() const { return first.energy() + second.energy(); }
  double approach() const { return (second.velocity - first.velocity).dot(normal); }
  Vector<D> contact() { return contact_velocity(normal, first.partner(), second.partner()); }
  Vector<D> momentum() const { return first.mass * first.velocity + second.mass * second.velocity; }
  /// About the point of contact: centres at R1 n and -R2 n.
  Spin<D> angular_momentum() const {
    return first.inertia * first.spin + second.inertia * second.spin +
           torque(normal,
                  first.radius * first.mass * first.velocity - second.radius * second.mass * second.velocity);
  }
  double reduced_mass() const { return first.mass * second.mass / (first.mass + second.mass); }
};

template <int D>
Ball<D> any_ball(Random& random) {
  Ball<D> ball{any<Vector<D>>(random), any<Spin<D>>(random), 0.1 + random.uniform(), 0.2 + random.uniform(),
               0};
  ball.inertia = (0.1 + 0.5 * random.uniform()) * ball.mass * ball.radius * ball.radius;
  return ball;
}

/// Approaching, of unequal mass, radius and ratio of inertia.
template <int D>
Pair<D> any_pair(Random& random) {
  Pair<D> pair{any_ball<D>(random), any_ball<D>(random), any<Vector<D>>(random).normalized()};
  if (pair.approach() < 0) pair.normal = -pair.normal;
  return pair;
}

inline Surface any_surface(Random& random) {
  return {{random.uniform(), random.uniform()}, 2 * random.uniform() - 1, random.uniform()};
}

}  // namespace sandglass
