#include "validation/check/worst.hpp"

#include "sim/base/error.hpp"

#include <cmath>

namespace sandglass {

void keep_worst(double& worst, double candidate) {
  if (!std::isnan(worst) && !(candidate <= worst)) worst = candidate;
}

void WorstRatio::offer(const Mean& ratio, const std::string& label) {
  ++comparisons_;
  const double significance = std::abs(ratio.value - 1) / ratio.standard_error;
  if (std::isnan(significance_) || significance <= significance_) return;
  significance_ = significance;
  ratio_ = ratio;
  label_ = label;
}

Evidence WorstRatio::evidence() const {
  if (comparisons_ == 0)
    throw InputError("nothing to compare: the record holds too few counts for this check");
  Evidence evidence = from_mean(ratio_, 1);
  evidence.comparisons = comparisons_;
  return evidence;
}

}  // namespace sandglass
