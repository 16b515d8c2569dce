#pragma once

#include "sim/base/random.hpp"

namespace sandglass {

/// Normal velocities of the particles of a Maxwellian stream that cross a plane upwards: density proportional to
/// W exp(-m (W - U)^2 / (2 T)) for W > 0. Drawn by rejection, exact for every stream speed.
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

}  // namespace sandglass
