#pragma once

#include "sim/base/statistics.hpp"
#include "validation/suite/outcome.hpp"

#include <string>
#include <vector>

namespace sandglass {

struct SweepValue {
  double knob = 0, value = 0, standard_error = 0;
  double error = 0;  ///< |value - reference|, or the standard error itself in a sweep of the replicas
  double cpu_seconds = 0, work = 0;
};

struct SweepResult {
  std::string case_name;
  const Sweep* sweep = nullptr;
  std::string units;
  double reference = 0, reference_error = 0;
  std::vector<SweepValue> points;
  double order = 0, order_error = 0;  ///< NaN when fewer than two points stand clear of the noise
  std::string order_reason;
};

/// The runs of a sweep: the reference first, then its points. Seeds are derived, so that no two share their
/// noise.
std::vector<Task> sweep_tasks(const Case& subject, const std::string& tier, const Sweep& sweep);

/// From the evidence of those runs, in the same order.
SweepResult evaluate_sweep(const Case& subject, const Sweep& sweep, const std::vector<Outcome>& outcomes);

}  // namespace sandglass
