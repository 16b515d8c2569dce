#pragma once

#include "sim/run/setup.hpp"

#include <cmath>
#include <vector>

namespace sandglass {

/// Square of the mean speed of a Maxwellian gas with T/m = 1: pi/2 in two dimensions, 8/pi in three.
inline double squared_mean_speed(int dimension) { return dimension == 2 ? M_PI / 2 : 8 / M_PI; }
/// Mean speed of a Maxwellian gas from sqrt(T/m).
double mean_speed(int dimension, double thermal_speed);

/// Enskog's collisions per particle and time of a gas of this granular temperature at the scene's mean density; the
/// contact value is one for a method without a contact factor.
template <int D>
double expected_collision_rate(const Scene& scene, const Setup<D>& setup, double temperature);

/// The length of each step: fixed, or such that a particle collides a wanted number of times per step.
template <int D>
class TimeStepper {
 public:
  TimeStepper(const Scene& scene, const Setup<D>& setup);

  /// Throws RunError when a gas without motion would need an infinite step.
  double next(const View<D>& view, std::uint64_t step);
  /// False: the step is current(), whatever the state.
  bool looks(std::uint64_t step) const { return fixed_ == 0 && (step % refresh_ == 0 || current_ == 0); }
  double current() const { return fixed_ > 0 ? fixed_ : current_; }
  std::vector<double> save() const { return {current_}; }
  void load(const std::vector<double>& state) { current_ = state.at(0); }

 private:
  double fixed_ = 0;
  double wanted_ = 0;          ///< collisions per particle and step
  double rate_at_one_ = 0;     ///< collision rate at granular temperature one
  std::uint64_t refresh_ = 1;  ///< steps between looks at the temperature
  double current_ = 0;
};

}  // namespace sandglass
