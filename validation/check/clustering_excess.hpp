#pragma once

#include "sim/base/statistics.hpp"
#include "validation/check/evidence.hpp"
#include "validation/check/subject.hpp"

#include <functional>
#include <vector>

namespace sandglass {

/// E(t)/E(0) (1 + t/t0)^2 of every replica: 1 on Haff's law. t0 = 2D/((1-r^2) omega) of the scene's temperature, and all
/// times in t0.
class ClusteringExcess {
 public:
  explicit ClusteringExcess(const Subject& subject);

  std::size_t replicas() const { return time_.size(); }
  double last() const;  ///< end of the shortest replica
  /// Straight line in the logarithm between samples; NaN beyond the last.
  double at(std::size_t replica, double time) const;
  Mean mean_at(double time) const;
  /// When the mean over replicas passes `mark(time)`, from above if `falls`. NaN when it never does.
  Mean passage(bool falls, const std::function<double(double)>& mark) const;
  /// Against the event-driven reference and Haff's law, at times equally spaced in the logarithm.
  Figure figure() const;

 private:
  std::vector<std::vector<double>> time_, value_;  ///< [replica][sample]
};

}  // namespace sandglass
