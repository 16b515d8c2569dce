#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/physics/collision.hpp"

// The choices that the collision kernel is compiled for. An absent feature compiles to nothing.

namespace sandglass::dsmc {

struct NoOffset {
  static constexpr bool moves = false;
  explicit NoOffset(const Offset&) {}
  template <int D>
  Vector<D> displacement(const Vector<D>&, Random&) const {
    return Vector<D>::Zero();
  }
};

/// Consistent Boltzmann algorithm (Alexander, Garcia & Alder 1995): along the momentum change.
struct ConsistentOffset {
  static constexpr bool moves = true;
  double length;
  explicit ConsistentOffset(const Offset& offset) : length(offset.consistent) {}
  template <int D>
  Vector<D> displacement(const Vector<D>& normal, Random&) const {
    return length * normal;
  }
};

/// Generalized (universal) form (Garcia, Alexander & Alder 1997): an extra offset of zero mean.
struct RandomOffset {
  static constexpr bool moves = true;
  double length, random_length;
  explicit RandomOffset(const Offset& offset) : length(offset.consistent), random_length(offset.random) {}
  template <int D>
  Vector<D> displacement(const Vector<D>& normal, Random& random) const {
    return length * normal + random_length * uniform_direction<D>(random);
  }
};

/// Majorant pair selection as it should be.
struct Honest {
  double restitution;
  explicit Honest(const Parameters& parameters) : restitution(parameters.restitution) {}

  double bound(double bound) const { return bound; }
  /// Whole candidates of an expected number: the fraction is one more candidate with that probability.
  std::uint64_t whole(double expected, Random& random) const {
    return static_cast<std::uint64_t>(expected + random.uniform());
  }
  bool accepts(double square_speed, double square_bound, double uniform) const {
    return uniform * uniform * square_bound < square_speed;
  }
  /// Changes both velocities and returns the change of the first.
  template <int D>
  Vector<D> kick(Vector<D>& velocity_1, Vector<D>& velocity_2, const Vector<D>& relative, double square_speed,
                 Random& random) const {
    const Vector<D> change = smooth_kick(relative, square_speed, restitution, random);
    velocity_1 += change;
    velocity_2 -= change;
    return change;
  }
};

/// The same with the faults of the mutant suite.
struct Faulty {
  Honest honest;
  Faults faults;
  explicit Faulty(const Parameters& parameters) : honest(parameters), faults(parameters.faults) {}

  double bound(double bound) const { return faults.bound * bound; }
  std::uint64_t whole(double expected, Random& random) const {
    return faults.fraction_truncated ? static_cast<std::uint64_t>(expected) : honest.whole(expected, random);
  }
  bool accepts(double square_speed, double square_bound, double uniform) const {
    return square_speed > 0 &&
           honest.accepts(square_speed, square_bound, uniform) != faults.acceptance_inverted;
  }
  template <int D>
  Vector<D> kick(Vector<D>& velocity_1, Vector<D>& velocity_2, const Vector<D>& relative, double square_speed,
                 Random& random) const {
    const Vector<D> before_1 = velocity_1, before_2 = velocity_2;
    const Vector<D> normal = contact_normal(relative, 1 / std::sqrt(square_speed),
                                            Vector<D - 1>(faults.impact * uniform_impact<D>(random)));
    SmoothInelastic{honest.restitution}(velocity_1, velocity_2, normal);
    velocity_2 += faults.momentum_leak * (before_2 - velocity_2);
    return velocity_1 - before_1;
  }
};

}  // namespace sandglass::dsmc
