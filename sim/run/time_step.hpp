#pragma once

#include "sim/base/saved.hpp"
#include "sim/run/setup.hpp"

#include <cstdint>

namespace sandglass {

/// The length of each step: fixed, or such that a particle collides a wanted number of times per step, or such that no
/// pair comes closer by more than a wanted part of a cell (Mueller 2001, 2.3.2: dt = r_s L / v_max, v_max twice the
/// largest speed, to which a fall through one cell is added here, for particles may start from rest).
template <int D>
class TimeStepper {
 public:
  explicit TimeStepper(const Setup<D>& setup);

  /// Throws RunError when a gas without motion would need an infinite step.
  double next(const View<D>& view, std::uint64_t step);
  /// False: the step is current(), whatever the state.
  bool looks(std::uint64_t step) const { return fixed_ == 0 && (step % refresh_ == 0 || current_ == 0); }
  double current() const { return fixed_ > 0 ? fixed_ : current_; }
  std::vector<double> save() const { return {current_}; }
  void load(const std::vector<double>& state) {
    current_ = saved_number(state.at(0), 0, 1e300, "a time step");
  }

 private:
  double for_collisions(const View<D>& view) const;
  double within_cells(const View<D>& view) const;

  double fixed_ = 0;
  double wanted_ = 0;          ///< collisions per particle and step
  double rate_at_one_ = 0;     ///< collision rate at granular temperature one, of `particles_`
  double particles_ = 0;       ///< at time zero
  double distance_ = 0;        ///< that a pair may come closer in a step; 0: by collisions
  double drive_speed_ = 0;     ///< that gravity or a wall may give a particle within a cell
  std::uint64_t refresh_ = 1;  ///< steps between looks at the temperature
  double current_ = 0;
};

}  // namespace sandglass
