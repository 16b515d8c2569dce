#pragma once

#include <vector>

namespace sandglass {

/// Energy of a clustering gas of hard disks over Haff's E0 (1 + t/t0)^-2, t0 = 2D/((1-r^2) omega): area fraction 0.25,
/// restitution 0.8, from equilibrium. Event-driven, 99856 disks, mean of eight runs: reference/source/MUL/README.md.
struct ClusteringPoint {
  double time;            ///< in t0
  double excess;          ///< E/E_Haff
  double standard_error;  ///< of the mean of the runs
};

const std::vector<ClusteringPoint>& clustering_reference();

/// Between the points ln(excess) is a straight line in ln(1 + t/t0). Throws InputError beyond the last.
double clustering_excess(double time);

}  // namespace sandglass
