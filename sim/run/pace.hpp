#pragma once

#include "sim/run/run.hpp"

#include <chrono>
#include <deque>

namespace sandglass {

/// Turns the work done so far into a rate and a believable time left: both are means over the last 20 reports.
class Pace {
 public:
  explicit Pace(const std::function<void(const Progress&)>& report) : report_(report) {}

  /// True a few times a second: then report() is worth calling.
  bool due() const;
  /// `fraction` of the whole run, `moves` particle-moves so far; fills in the rest of `progress` and passes it on.
  void report(Progress progress, double moves);

 private:
  using Clock = std::chrono::steady_clock;
  struct Mark {
    Clock::time_point when;
    double fraction, moves;
  };

  const std::function<void(const Progress&)>& report_;
  std::deque<Mark> marks_{{Clock::now(), 0, 0}};
};

}  // namespace sandglass
