#pragma once

#include <vector>

namespace sandglass {

/// Correlations of pairs of hard disks 2 to 5 diameters apart after 140 collisions per particle: g - 1, and the mean products
/// of velocities over T/m, along the line between the two and across it; reference/source/MUL/README.md.
struct PairPoint {
  double particles, area_fraction, restitution;
  double density, density_error;  ///< of the mean of the runs
  double parallel, parallel_error;
  double transverse, transverse_error;
};

inline constexpr double kPairFrom = 2, kPairTo = 5, kPairCollisions = 140;

const std::vector<PairPoint>& pair_reference();

/// None where the reference has no such gas.
const PairPoint* find_pair_reference(double particles, double area_fraction, double restitution);

/// Throws InputError naming the points that there are.
const PairPoint& pair_reference_at(double particles, double area_fraction, double restitution);

}  // namespace sandglass
