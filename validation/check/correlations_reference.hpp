#pragma once

#include <vector>

namespace sandglass {

/// ln(E/E0) of a cooling gas of disks against collisions per particle, three methods with uniform impact parameters:
/// area fractions 0.05 and 0.245, restitution 0.85, from equilibrium; reference/source/MUL/README.md.
struct CoolingPoint {
  double particles;
  double area_fraction;
  double collisions;                        ///< per particle
  double event_driven, event_driven_error;  ///< of the mean of the runs
  double hsmc, hsmc_error;
  double dsmc, dsmc_error;
};

const std::vector<CoolingPoint>& correlations_reference();

/// Throws InputError naming the points that there are.
const CoolingPoint& correlations_reference_at(double particles, double area_fraction, double collisions);

}  // namespace sandglass
