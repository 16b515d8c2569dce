#pragma once

#include "sim/scene/scene.hpp"

#include <cmath>
#include <optional>

namespace sandglass {

/// Where a run stands.
struct Clock {
  std::uint64_t step = 0;
  double time = 0;
  double collisions = 0;  ///< per particle, 2 C / N

  double reading(Cadence::Unit unit) const {
    if (unit == Cadence::Unit::time) return time;
    return unit == Cadence::Unit::steps ? static_cast<double>(step) : collisions;
  }
};

/// Says at the end of each step whether something is due. Its state follows from the clock alone.
class Schedule {
 public:
  explicit Schedule(const Cadence& cadence) : cadence_(cadence) {}

  /// True at most once per step: a step that passes several marks is one sample.
  bool due(const Clock& clock) {
    const double marks = count(clock);
    const bool passed = marks > passed_;
    passed_ = marks;
    return passed;
  }
  /// Goes on from a clock without reporting the marks before it.
  void resume(const Clock& clock) { passed_ = count(clock); }

 private:
  /// Marks passed, with a little room for the rounding of the clock.
  double count(const Clock& clock) const {
    return std::floor(clock.reading(cadence_.unit) / cadence_.every * (1 + 1e-12) + 1e-12);
  }

  Cadence cadence_;
  double passed_ = 0;
};

/// Whether the clock has come to a moment, given as time, steps or collisions from zero.
inline bool reached(const Cadence& moment, const Clock& clock) {
  return clock.reading(moment.unit) >= moment.every * (1 - 1e-12);
}

/// The duration as a cadence whose first mark ends the run.
inline Cadence end_of(const Duration& duration) {
  if (duration.time) return {Cadence::Unit::time, *duration.time};
  if (duration.steps) return {Cadence::Unit::steps, static_cast<double>(*duration.steps)};
  return {Cadence::Unit::collisions, duration.collisions.value()};
}

/// Part of the run that is done, 0 to 1.
inline double fraction_done(const Duration& duration, const Clock& clock) {
  const Cadence end = end_of(duration);
  return clock.reading(end.unit) / end.every;
}

inline bool finished(const Duration& duration, const Clock& clock) {
  return fraction_done(duration, clock) * (1 + 1e-12) >= 1;
}

}  // namespace sandglass
