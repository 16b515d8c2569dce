#pragma once

#include <array>
#include <cstdint>
#include <vector>

// Examples 1 and 2 of Greenspan 1972, by a transcription of the source's listing into Python that shares no line with the
// simulation: validation/case/mixing/two-fluid-mixing/README.md.

namespace sandglass {

/// Places of the sixteen particles of example 1, in the order of the source's table and from the numbers that it prints,
/// to six digits behind the point.
struct FluidPlaces {
  std::uint64_t step;
  std::vector<std::array<double, 2>> places;
};
const std::vector<FluidPlaces>& example_one_places();

/// A mean over runs and its standard error.
struct ReferenceMean {
  double value, standard_error;
};

/// Means over starts that differ within the printed digits (example 1) or in their random velocities (example 2).
struct FluidMeans {
  std::uint64_t step;
  ReferenceMean heavy, light;  ///< heights
  ReferenceMean energy;        ///< kinetic, of all particles; example 2 alone
};
const std::vector<FluidMeans>& example_one_means();
/// Share of those starts of example 1 that end as the source says, by samples every 40 steps.
ReferenceMean example_one_outcome();
const std::vector<FluidMeans>& example_two_means();

}  // namespace sandglass
