#include "validation/check/clustering_reference.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

const std::vector<ClusteringPoint>& clustering_reference() {
  static const std::vector<ClusteringPoint> points = {
      {0, 1, 0},
      {0.2, 1.006, 0.0008},
      {0.5, 1.0252, 0.0009},
      {1, 1.0617, 0.001},
      {2, 1.1378, 0.0015},
      {3, 1.2117, 0.0019},
      {5, 1.3592, 0.0031},
      {7, 1.5124, 0.0047},
      {10, 1.7568, 0.0071},
      {15, 2.2012, 0.0126},
      {20, 2.6878, 0.0201},
      {30, 3.7585, 0.0365},
      {50, 6.1435, 0.0716},
      {70, 8.7023, 0.1023},
      {100, 12.6875, 0.1298},
  };
  return points;
}

double clustering_excess(double time) {
  const std::vector<ClusteringPoint>& points = clustering_reference();
  if (!(time >= 0 && time <= points.back().time))
    throw InputError(
        fmt::format("the reference of the clustering gas goes to t/t0 = {}, not to {}: run shorter",
                    points.back().time, time));
  const auto after = std::upper_bound(points.begin() + 1, points.end() - 1, time,
                                      [](double t, const ClusteringPoint& point) { return t < point.time; });
  const ClusteringPoint &a = *(after - 1), &b = *after;
  const double share = std::log((1 + time) / (1 + a.time)) / std::log((1 + b.time) / (1 + a.time));
  return std::exp((1 - share) * std::log(a.excess) + share * std::log(b.excess));
}

}  // namespace sandglass
