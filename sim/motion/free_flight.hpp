#pragma once

#include "sim/base/vector.hpp"
#include "sim/space/lanes.hpp"

#include <cmath>

namespace sandglass::motion {

/// Both numbers of every lane that counts.
template <int D, class Mask>
[[gnu::always_inline]] inline bool all(const Mask& in) {
  if constexpr (D == 2)
    return (in[0] & in[1]) != 0;
  else
    return (in[0] & in[1] & in[2]) != 0;
}

/// Flight without boundaries, all axes at once.
template <int D>
class FreeFlight {
 public:
  using Real = typename Lanes<D>::Real;

  FreeFlight(const Vector<D>& gravity, const Vector<D>& box, double dt)
      : gain_(Lanes<D>::from(Vector<D>(gravity * dt), 0)),
        half_gain_(0.5 * gain_),
        box_(Lanes<D>::from(box, HUGE_VAL)),
        dt_(dt) {}

  template <bool Gravity>
  Real end(const Real& position, const Real& velocity) const {
    if constexpr (Gravity) return position + dt_ * (velocity + half_gain_);
    return position + dt_ * velocity;
  }
  bool inside(const Real& position) const {
    return all<D>((position >= 0) & (position < box_));  // false for what is not a number
  }
  const Real& gain() const { return gain_; }

 private:
  Real gain_, half_gain_, box_;
  double dt_;
};

}  // namespace sandglass::motion
