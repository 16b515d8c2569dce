#pragma once

#include "sim/observe/shells.hpp"

namespace sandglass {

/// Correlation of the velocities of two particles over their distance r, in a box that is periodic along every axis: the
/// mean over the pairs of a shell of C_1.e C_2.e, with C relative to the centre of mass and e the unit vector from one to
/// the other (parallel), or across it (transverse; the mean over the D - 1 directions). These are G_par and G_perp of
/// Müller 2001, section 3.6.2, of particles instead of a field; for independent particles -<C^2>/D (N - 1), since no
/// momentum is left over. A shell without a pair shows 0.
template <int D>
class PairVelocity final : public Observer<D> {
 public:
  enum class Component { parallel, transverse };

  /// Reads `range` (distances) and `bins`. Throws InputError for a range that is not one of distances.
  PairVelocity(const ObserverSpec& spec, Component component)
      : spec_(spec), shells_(spec), component_(component) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  /// Throws InputError for fewer than 2 particles, for weights, or for a range beyond half the box.
  void start(const View<D>& view) override;

 private:
  ObserverSpec spec_;
  Shells shells_;
  Component component_;
};

}  // namespace sandglass
