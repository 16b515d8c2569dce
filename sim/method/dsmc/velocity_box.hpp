#pragma once

#include "sim/space/lanes.hpp"
#include "sim/space/particle_store.hpp"

#include <algorithm>
#include <cstdint>

namespace sandglass::dsmc {

/// Smallest box in velocity space around the velocities of a cell. Its diagonal bounds every relative speed, and its
/// edges are cheap to keep as collisions change the velocities: no pair is ever above the bound.
template <int D>
class VelocityBox {
 public:
  using Lane = Lanes<D>;
  using Real = typename Lane::Real;

  VelocityBox() = default;
  /// Eight particles at a time, the last one again where there are fewer: a loop whose end can be guessed.
  VelocityBox(const Phase<D>* particles, std::uint32_t count) : low_(velocity_of(particles[0])), high_(low_) {
    const std::uint32_t last = std::max(count, 1u) - 1;
    for (std::uint32_t i = 0; i <= last; i += 8)
      for (std::uint32_t lane = 0; lane < 8; ++lane)
        include(velocity_of(particles[std::min(i + lane, last)]));
  }
  void include(const Real& velocity) {
    low_ = velocity < low_ ? velocity : low_;
    high_ = velocity > high_ ? velocity : high_;
  }
  void include(const VelocityBox& other) {
    include(other.low_);
    include(other.high_);
  }
  double square_diagonal() const {
    const Real edge = high_ - low_;
    const Real square = edge * edge;
    double sum = square[0] + square[1];
    if constexpr (D == 3) sum += square[2];
    return sum;
  }

 private:
  static Real velocity_of(const Phase<D>& particle) { return Lane::load(particle.position.data() + D); }

  Real low_, high_;
};

}  // namespace sandglass::dsmc
