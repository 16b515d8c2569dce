#include "validation/check/wave_speed.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
using Correlation = std::vector<double>;  ///< [(lag - 1) * slices + displacement]

/// Deviations from the mean of each slice.
std::vector<double> deviations(const SpaceTime& data) {
  const std::size_t samples = data.density.size() / data.slices;
  std::vector<double> values(data.density.begin(), data.density.end());
  for (std::size_t slice = 0; slice < data.slices; ++slice) {
    double mean = 0;
    for (std::size_t t = 0; t < samples; ++t) mean += values[t * data.slices + slice];
    mean /= static_cast<double>(samples);
    for (std::size_t t = 0; t < samples; ++t) values[t * data.slices + slice] -= mean;
  }
  return values;
}

/// Pairs of samples whose later one lies in [first, last).
Correlation correlation_of(const std::vector<double>& values, std::size_t slices, std::size_t lags,
                           std::size_t first, std::size_t last) {
  Correlation correlation(lags * slices, 0.0);
  for (std::size_t t = first; t < last; ++t)
    for (std::size_t lag = 1; lag <= std::min(lags, t); ++lag) {
      const double *now = &values[t * slices], *before = &values[(t - lag) * slices];
      for (std::size_t shift = 0; shift < slices; ++shift)
        for (std::size_t slice = 0; slice < slices; ++slice)
          correlation[(lag - 1) * slices + shift] += before[slice] * now[(slice + shift) % slices];
    }
  return correlation;
}

/// Highest point of one lag near an expected displacement, in slices; a parabola through three points.
double displacement(std::span<const double> correlation, double expected) {
  const auto slices = static_cast<long>(correlation.size());
  const auto at = [&](long shift) {
    return correlation[static_cast<std::size_t>(((shift % slices) + slices) % slices)];
  };
  const long middle = std::lround(expected);
  long best = middle;
  for (long shift = middle - (slices - 1) / 2; shift <= middle + (slices - 1) / 2; ++shift)
    if (at(shift) > at(best)) best = shift;
  const double left = at(best - 1), right = at(best + 1), bend = left - 2 * at(best) + right;
  return static_cast<double>(best) + (bend < 0 ? (left - right) / (2 * bend) : 0);
}

/// Slices per sample.
double slope_of(const Correlation& correlation, std::size_t slices, std::size_t lags) {
  double product = 0, norm = 0;
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    const auto time = static_cast<double>(lag);
    const double expected = norm > 0 ? product / norm * time : 0;
    product += time * displacement(std::span(correlation).subspan((lag - 1) * slices, slices), expected);
    norm += time * time;
  }
  return product / norm;
}
/// From the sum of the parts, with the error by leaving out one of them.
Mean from_parts(const std::vector<Correlation>& parts, const SpaceTime& data, std::size_t lags) {
  Mean speed = jackknife(parts.size(), [&](std::span<const std::size_t> used) {
    Correlation sum(lags * data.slices, 0.0);
    for (std::size_t part : used)
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += parts[part][i];
    return slope_of(sum, data.slices, lags);
  });
  speed.value *= data.spacing / data.interval;
  speed.standard_error *= data.spacing / data.interval;
  return speed;
}

/// Samples of data that hold enough for this many parts.
std::size_t samples_of(const SpaceTime& data, std::size_t lags, std::size_t parts) {
  const std::size_t samples = data.slices > 0 ? data.density.size() / data.slices : 0;
  if (data.slices < 4 || lags < 1 || parts < 1 || samples < 2 * parts * lags)
    throw InputError(
        fmt::format("{} samples of {} slices are too few for {} lags and {} blocks: 4 slices and 2 x lags x "
                    "blocks samples at least",
                    samples, data.slices, lags, parts));
  return samples;
}
}  // namespace

Mean wave_speed(const SpaceTime& data, std::size_t lags, std::size_t blocks) {
  const std::size_t samples = samples_of(data, lags, std::max<std::size_t>(blocks, 2));
  const std::vector<double> values = deviations(data);
  std::vector<Correlation> parts;
  for (std::size_t block = 0; block < blocks; ++block)
    parts.push_back(
        correlation_of(values, data.slices, lags, block * samples / blocks, (block + 1) * samples / blocks));
  return from_parts(parts, data, lags);
}

Mean wave_speed(std::span<const SpaceTime> runs, std::size_t lags) {
  SANDGLASS_EXPECT(runs.size() > 1);
  std::vector<Correlation> parts;
  for (const SpaceTime& run : runs)
    parts.push_back(correlation_of(deviations(run), run.slices, lags, 0, samples_of(run, lags, 1)));
  return from_parts(parts, runs.front(), lags);
}

}  // namespace sandglass
