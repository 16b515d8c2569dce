#pragma once

#include "validation/law/vibrated_bed.hpp"

#include <vector>

namespace sandglass {

/// Rise of the centre of mass of hard particles over its height at rest, event-driven: the scenes of the case
/// `vibrated-bed`, tier `paper`; reference/source/MUL/README.md.
struct BedPoint {
  double restitution, wall_restitution;  ///< of all walls
  double speed;                          ///< V = 2 pi A f [m/s]
  double rise, standard_error;           ///< [m]
};

/// Disks, 5 layers, in order of V for each pair of restitutions.
const std::vector<BedPoint>& vibrated_bed_reference();

/// The points with the restitutions of the bed.
std::vector<BedPoint> reference_of(const law::VibratedBed& bed);

/// The point of the bed at the given V. Throws InputError naming those that there are.
BedPoint reference_at(const law::VibratedBed& bed, double speed);

}  // namespace sandglass
