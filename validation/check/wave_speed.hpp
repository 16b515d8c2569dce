#pragma once

#include "sim/base/statistics.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace sandglass {

/// A density in slices along a periodic axis at equal intervals of time: slice s of sample t at [t * slices + s].
struct SpaceTime {
  std::span<const double> density;
  std::size_t slices = 0;
  double spacing = 1;   ///< between slices
  double interval = 1;  ///< between samples
};

/// Speed of waves along the axis from the cross-correlation of slices: for each lag up to `lags` samples the
/// displacement of its highest point, by a parabola through three, then a line through the origin. A wave must move less
/// than half the axis in one sample. The mean of each slice over time is taken off first. Error by leaving out one of
/// `blocks` stretches of time, which must be long against the correlation time.
Mean wave_speed(const SpaceTime& data, std::size_t lags, std::size_t blocks);
/// Of independent runs of the same axis and interval, two at least: from the sum of their correlations; error by leaving
/// out one run.
Mean wave_speed(std::span<const SpaceTime> runs, std::size_t lags);

}  // namespace sandglass
