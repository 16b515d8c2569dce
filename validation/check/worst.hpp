#pragma once

#include "sim/base/statistics.hpp"
#include "validation/check/evidence.hpp"

#include <string>

namespace sandglass {

/// The larger of two deviations; one that is not a number stays: nothing replaces it.
void keep_worst(double& worst, double candidate);

/// Keeps the ratio to theory that is furthest from one in its own standard errors: the evidence of a check
/// that makes many comparisons at once. A ratio that is not a number stays: nothing replaces it.
class WorstRatio {
 public:
  void offer(const Mean& ratio, const std::string& label);
  /// Value, error and number of comparisons; expected one. Throws InputError when nothing was offered.
  Evidence evidence() const;
  const std::string& label() const { return label_; }

 private:
  Mean ratio_;
  std::string label_;
  double significance_ = -1;
  int comparisons_ = 0;
};

}  // namespace sandglass
