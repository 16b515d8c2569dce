#pragma once

#include "sim/base/random.hpp"
#include "sim/base/vector.hpp"

namespace sandglass {

/// Normal velocities of the particles of a Maxwellian stream that cross a plane upwards: density proportional to
/// W exp(-m (W - U)^2 / (2 T)) for W > 0. Drawn by rejection, exact for every stream speed; those of a beam, T = 0, are U.
class FluxSampler {
 public:
  /// Stream speed U along the normal and thermal speed sqrt(T/m).
  FluxSampler(double stream, double thermal);

  double operator()(Random& random) const;
  /// Crossings per area and time of particles with number density one: E[max(v, 0)].
  double rate() const;

 private:
  double forward(Random& random) const;
  double backward(Random& random) const;

  double stream_, thermal_;
  double ratio_;  ///< U / (sqrt(2) thermal)
  double mode_;   ///< most probable velocity over sqrt(2) thermal
};

/// Particles of a Maxwellian stream that pass a plane normal to an axis: velocities from the flux distribution along the
/// normal, Maxwell's about the stream along the plane.
template <int D>
class StreamFlux {
 public:
  /// `direction`: +1 or -1, the way along the axis.
  StreamFlux(const Vector<D>& stream, double thermal, int axis, double direction)
      : stream_(stream),
        thermal_(thermal),
        axis_(axis),
        direction_(direction),
        normal_(direction * stream[axis], thermal) {}

  /// Per area and time, of particles with number density one.
  double rate() const { return normal_.rate(); }
  Vector<D> operator()(Random& random) const;

 private:
  Vector<D> stream_;
  double thermal_;
  int axis_;
  double direction_;
  FluxSampler normal_;
};

extern template class StreamFlux<2>;
extern template class StreamFlux<3>;

}  // namespace sandglass
