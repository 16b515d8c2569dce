#pragma once

#include "sim/base/exact_sum.hpp"
#include "sim/base/vector.hpp"

#include <array>
#include <vector>

namespace sandglass {

/// What simulated particles and the sides of the box give each other, since time zero. Exact sums: the order of the hits
/// cannot show.
template <int D>
class WallImpulses {
 public:
  static constexpr std::size_t side(int axis, bool high) { return static_cast<std::size_t>(2 * axis) + high; }

  /// A particle has given the momentum `impulse` to a side that moves with `velocity`, and lost the kinetic energy `heat` in
  /// the frame of the side.
  void add(std::size_t side, const Vector<D>& impulse, const Vector<D>& velocity, double heat) {
    for (int axis = 0; axis < D; ++axis) sums_[side][static_cast<std::size_t>(axis)].add(impulse[axis]);
    if (!velocity.isZero(0)) sums_[side][D].add(-impulse.dot(velocity));
    if (heat != 0) sums_[side][D + 1].add(heat);
  }

  /// Momentum that the side has taken.
  Vector<D> impulse(std::size_t side) const;
  /// Work that the side has done on the particles: of the force on them, along its own way.
  double work(std::size_t side) const { return sums_[side][D].value(); }
  /// Energy that the side has taken from the particles beside its work; negative for a wall that heats them.
  double heat(std::size_t side) const { return sums_[side][D + 1].value(); }

  /// What other particles have given.
  void add(const WallImpulses& other);

  std::vector<double> save() const;
  /// Throws std::out_of_range when numbers lack.
  void load(const std::vector<double>& state);

 private:
  std::array<std::array<ExactSum, D + 2>, 2 * D> sums_;  ///< momentum, work, heat
};

extern template class WallImpulses<2>;
extern template class WallImpulses<3>;

}  // namespace sandglass
