#pragma once

#include "sim/base/vector.hpp"
#include "sim/space/phase.hpp"

#include <cstdint>

namespace sandglass::mixing {

/// What a wall does to a particle that has left the box within a step (WALCOL of the listing in Greenspan 1972). It is set
/// back inside: `speed_factor` times as far as it was out, and along the wall by `speed_factor` squared times what it had
/// gone there. Its speed is multiplied by the factor and by s / (s + smallest_length), s its path since the wall; its
/// direction is that of this path. Several walls may act in a step, one after the other.
struct WallRule {
  Vector<2> box = Vector<2>::Zero();
  double speed_factor = 1;        ///< omega, DAMP of the listing
  double smallest_length = 1e-3;  ///< EPS of the listing

  /// Puts a particle that came from `start` back into the box; how many walls it took, or more than `most` when it is still
  /// outside.
  std::uint32_t turn_back(const Vector<2>& start, Phase<2>& particle, std::uint32_t most) const;

 private:
  void reflect(int axis, double wall, Vector<2>& start, Phase<2>& particle) const;
};

}  // namespace sandglass::mixing
