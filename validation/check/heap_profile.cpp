#include "validation/check/heap_profile.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sandglass {

double HeapProfile::area() const { return bin * std::accumulate(h.begin(), h.end(), 0.0); }

double HeapProfile::height() const {
  return 1.5 * bin * std::inner_product(h.begin(), h.end(), h.begin(), 0.0) / area();
}

namespace {
constexpr double kWindow = 10;  ///< particles poured before and after

/// Samples [first, last) of the window around one.
std::pair<std::size_t, std::size_t> window_of(const Subject& subject, std::size_t sample) {
  const std::vector<double>& times = subject.series(0, "free-surface").time;
  const double reach = kWindow / subject.scene().sources.at(0).rate;
  const auto first = std::lower_bound(times.begin(), times.end(), times.at(sample) - reach);
  const auto last = std::upper_bound(times.begin(), times.end(), times[sample] + reach);
  return {static_cast<std::size_t>(first - times.begin()), static_cast<std::size_t>(last - times.begin())};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Bins over the source get the mean of the nearest beside it.
void close_stream(const Source& source, HeapProfile& profile) {
  const double half = profile.bin / 2, width = source.width.empty() ? 0 : source.width[0] / 2;
  std::size_t first = 0, last = profile.x.size();
  while (first < last && profile.x[first] + half <= -width) ++first;
  while (last > first && profile.x[last - 1] - half > width) --last;
  if (first == 0 || last == profile.x.size()) return;
  std::fill(profile.h.begin() + static_cast<std::ptrdiff_t>(first),
            profile.h.begin() + static_cast<std::ptrdiff_t>(last),
            (profile.h[first - 1] + profile.h[last]) / 2);
}
}  // namespace

HeapProfile heap_profile(const Subject& subject, std::size_t sample, std::span<const std::size_t> replicas) {
  const std::size_t bins = subject.series(0, "free-surface").quantity.size();
  HeapProfile profile;
  profile.bin = subject.scene().domain.size.at(0) / static_cast<double>(bins);
  profile.diameter = subject.species().diameter;
  const double centre = subject.scene().sources.at(0).centre.at(0);
  for (std::size_t bin = 0; bin < bins; ++bin)
    profile.x.push_back((static_cast<double>(bin) + 0.5) * profile.bin - centre);
  profile.h.assign(bins, 0);
  const auto [first, last] = window_of(subject, sample);
  for (const std::size_t replica : replicas) {
    const std::vector<double>& values = subject.series(replica, "free-surface").value;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      std::vector<double> heights;
      for (std::size_t i = first; i < last; ++i) heights.push_back(values.at(i * bins + bin));
      profile.h[bin] += median(std::move(heights)) / static_cast<double>(replicas.size());
    }
  }
  if (subject.series(0, "free-surface").time[sample] <= end_of_pouring(subject) * (1 + 1e-9))
    close_stream(subject.scene().sources[0], profile);
  return profile;
}

double heap_side_slope(const HeapProfile& profile, int side, double from, double to) {
  double count = 0, x = 0, h = 0, xx = 0, xh = 0;
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    const double distance = side * profile.x[i], half = profile.bin / 2;
    const double part = (std::min(distance + half, to) - std::max(distance - half, from)) / profile.bin;
    if (part <= 0) continue;
    count += part, x += part * distance, h += part * profile.h[i];
    xx += part * distance * distance, xh += part * distance * profile.h[i];
  }
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  return -(xh - x * h / count) / (xx - x * x / count);
}

double heap_slope(const HeapProfile& profile, double from, double to) {
  return (heap_side_slope(profile, -1, from, to) + heap_side_slope(profile, 1, from, to)) / 2;
}

HeapPoints below_head(const HeapProfile& profile) {
  const double half = profile.half_base();
  HeapPoints points;
  for (std::size_t i = 0; i < profile.x.size(); ++i)
    if (std::abs(profile.x[i]) >= kStraightFrom * half && std::abs(profile.x[i]) <= 2 * half)
      points.x.push_back(profile.x[i]), points.h.push_back(profile.h[i]);
  return points;
}

std::size_t heap_sample_at(const Subject& subject, double time) {
  const std::vector<double>& times = subject.series(0, "free-surface").time;
  const auto found = std::lower_bound(times.begin(), times.end(), time * (1 - 1e-9));
  if (found == times.end())
    throw InputError(
        "the surface of the heap is not sampled after the end of pouring: lengthen 'run.duration'");
  return static_cast<std::size_t>(found - times.begin());
}

double end_of_pouring(const Subject& subject) {
  const Source& source = subject.scene().sources.at(0);
  if (!source.count) return subject.series(0, "free-surface").time.back();
  return static_cast<double>(*source.count) / source.rate;
}

double poured_by(const Subject& subject, double time) {
  const Source& source = subject.scene().sources.at(0);
  const double due = std::floor(source.rate * time);
  return source.count ? std::min(due, static_cast<double>(*source.count)) : due;
}

bool is_heap(const Scene& scene) {
  return scene.domain.dimension == 2 && scene.sources.size() == 1 && scene.sources.front().height &&
         scene.gravity.size() == 2 && scene.gravity[0] == 0 && scene.gravity[1] < 0;
}

bool is_closed_heap(const Scene& scene) { return is_heap(scene) && !has_open_side(scene.domain); }

}  // namespace sandglass
