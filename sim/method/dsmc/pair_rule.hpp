#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/physics/collision.hpp"

namespace sandglass::dsmc {

/// What pair rules draw in the same way unless they say otherwise.
template <int D>
struct PairRule {
  /// Whole candidates of an expected number: the fraction is one more candidate with that probability.
  std::uint64_t whole(double expected, Random& random) const {
    return static_cast<std::uint64_t>(expected + random.uniform());
  }
  /// Moves the partners of a collision apart.
  template <class Columns>
  void displace(const Columns& columns, const Pair& pair, const Vector<D>& shift) const {
    columns.phases[pair.first].position += shift;
    columns.phases[pair.second].position -= shift;
  }
  /// Impact parameter in diameters.
  template <class Columns>
  Vector<D - 1> impact(const Columns&, Random& random) const {
    return uniform_impact<D>(random);
  }
};

}  // namespace sandglass::dsmc
