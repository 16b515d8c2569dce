#include "sim/base/error.hpp"
#include "validation/check/falling.hpp"
#include "validation/check/families.hpp"
#include "validation/check/heap_profile.hpp"
#include "validation/check/heap_shape.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

// How a heap grows: heights of all smaller heaps from the shape of the largest, and how much has been poured.

namespace sandglass {

namespace {
using Replicas = std::span<const std::size_t>;

/// What HeapProfile::height() gives of the law: integral of h^2 is 2 h_m^3/(3m) + (l/r) h_m^2, from 2 h x dh.
double height_of(const law::Heap& heap) {
  const double square = heap.height * heap.height * (2 * heap.height / (3 * heap.slope) + heap.kink_length);
  return 1.5 * square / law::heap_area(heap);
}

/// The heap of the law that has the area and the height of the profile, with kinks of this length: from height_of() and
/// heap_area() h_m solves (l/r) h_m^2/2 - A h_m + A H = 0. Not a number where kinks leave no slope, from 3/8 of half the
/// base on.
law::Heap heap_like(const HeapProfile& profile, double kink_length) {
  const double area = profile.area(), height = profile.height();
  const double top = 2 * height * area / (area + std::sqrt(area * area - 2 * kink_length * area * height));
  const double slope = top * top / (area - 2 * kink_length * top);
  return {top, slope > 0 ? slope : std::numeric_limits<double>::quiet_NaN(), kink_length};
}

/// l/r of the largest heap of one replica. A layer has none: there it is as long as kinks can be, as where no shape fits.
double kink_length(const Subject& subject, std::size_t last, std::size_t replica) {
  const double most = kMostKink * subject.species().diameter;
  const HeapPoints points = below_head(heap_profile(subject, last, std::span(&replica, 1)));
  try {
    return std::min(most, fit_kinked_heap(points.x, points.h).heap.kink_length);
  } catch (const InputError&) {
    return most;
  }
}

std::vector<double> kink_lengths(const Subject& subject, std::size_t last) {
  std::vector<double> lengths;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    lengths.push_back(kink_length(subject, last, replica));
  return lengths;
}

constexpr std::size_t kSizes = 4;  ///< smaller heaps that are compared

/// Some of the samples between `least` particles and the end of pouring, the last of them being the one that is fitted.
std::vector<std::size_t> growing_samples(const Subject& subject, double least) {
  const std::vector<double>& times = subject.series(0, "free-surface").time;
  std::vector<std::size_t> samples;
  for (std::size_t i = 0; i < times.size() && times[i] <= end_of_pouring(subject) * (1 + 1e-9); ++i)
    if (poured_by(subject, times[i]) >= least) samples.push_back(i);
  if (samples.size() < 2)
    throw InputError(fmt::format(
        "fewer than two samples of 'free-surface' between {} particles and the end of pouring", least));
  if (samples.size() <= kSizes + 1) return samples;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i <= kSizes; ++i) some.push_back(samples[i * (samples.size() - 1) / kSizes]);
  return some;
}

double particles_at(const Subject& subject, std::size_t sample) {
  return poured_by(subject, subject.series(0, "free-surface").time[sample]);
}

double mean_over(const std::vector<double>& values, Replicas replicas) {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += values[replica];
  return sum / static_cast<double>(replicas.size());
}

/// What is compared: heaps at some samples with the law that the last of them gives.
class GrowingHeap {
 public:
  GrowingHeap(const Subject& subject, double least)
      : subject_(subject),
        samples_(growing_samples(subject, least)),
        kinks_(kink_lengths(subject, samples_.back())) {}

  const std::vector<std::size_t>& samples() const { return samples_; }
  std::span<const std::size_t> smaller() const { return {samples_.data(), samples_.size() - 1}; }
  Mean kink_length() const { return mean_of_independent(kinks_); }

  /// A bare floor has not grown, nor has a layer from wall to wall.
  Mean height_ratio(std::size_t sample) const {
    return jackknife(subject_.replicas(), [&](Replicas replicas) {
      const double expected = expected_height(sample, replicas);
      return expected > 0 ? heap_profile(subject_, sample, replicas).height() / expected : 0;
    });
  }

  /// Half an edge of a cell for all heights alike, as no method of cells knows a place better: over that of the smallest
  /// heap, less what it does to the largest.
  double place_in_cell() const {
    std::vector<std::size_t> all(subject_.replicas());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const double small = expected_height(samples_.front(), all),
                 large = expected_height(samples_.back(), all);
    return small > 0 ? cell_edge(subject_) / 2 * (1 / small - 1 / large) : 0;
  }

 private:
  /// Of the law with slope and kinks of the largest heap, the area in proportion to the particles poured.
  double expected_height(std::size_t sample, Replicas replicas) const {
    const HeapProfile largest = heap_profile(subject_, samples_.back(), replicas);
    if (largest.is_bare() || largest.half_base() > largest.width() / 2) return 0;
    const double share = particles_at(subject_, sample) / particles_at(subject_, samples_.back());
    law::Heap heap = heap_like(largest, mean_over(kinks_, replicas));
    heap.height = law::heap_height(largest.area() * share, heap.slope, heap.kink_length);
    return height_of(heap);
  }

  const Subject& subject_;
  std::vector<std::size_t> samples_;
  std::vector<double> kinks_;
};

/// (3.13): surfaces over the root of the number of particles.
Figure collapse_figure(const Subject& subject, const std::vector<std::size_t>& samples) {
  Figure figure{"Growing heap, collapsed", {"x / sqrt(N)", "length"}, {"h / sqrt(N)", "length"}, {}, {}};
  std::vector<std::size_t> replicas(subject.replicas());
  std::iota(replicas.begin(), replicas.end(), std::size_t{0});
  for (const std::size_t sample : samples) {
    const double unit = std::sqrt(particles_at(subject, sample));
    const HeapProfile profile = heap_profile(subject, sample, replicas);
    Figure::Line line{fmt::format("N = {:.0f}", particles_at(subject, sample)), {}, {}};
    for (std::size_t i = 0; i < profile.x.size(); ++i)
      line.x.push_back(profile.x[i] / unit), line.y.push_back(profile.h[i] / unit);
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

Evidence growth_evidence(const Subject& subject, const law::Arguments& numbers) {
  const GrowingHeap heap(subject, numbers.at("least-particles"));
  WorstRatio worst;
  Figure heights{"Height of the growing heap over the law", {"particles", "1"}, {"ratio", "1"}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (const std::size_t sample : heap.smaller()) {
    const Mean ratio = heap.height_ratio(sample);
    const double particles = particles_at(subject, sample);
    worst.offer(ratio, fmt::format("{:.0f} particles", particles));
    points.x.push_back(particles), points.y.push_back(ratio.value);
    points.error.push_back(ratio.standard_error), points.expected.push_back(1);
  }
  Evidence evidence = worst.evidence();
  evidence.budget.systematic = heap.place_in_cell();
  evidence.budget.reason = "half an edge of a cell in all heights";
  evidence.summary = fmt::format(
      "height of the smaller heaps over that which the shape of the largest gives, l/r {:.2g} ± {:.2g}; "
      "worst: {}",
      heap.kink_length().value, heap.kink_length().standard_error, worst.label());
  heights.points.push_back(std::move(points));
  evidence.figures = {std::move(heights), collapse_figure(subject, heap.samples())};
  return evidence;
}

/// Particles in the box from `fields`, less those poured by then; the largest difference.
Evidence rate_evidence(const Subject& subject, const law::Arguments&) {
  const Scene& scene = subject.scene();
  double worst = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& fields = subject.series(replica, "fields");
    const std::size_t bins = fields.quantity.size() / 4;
    const double volume = scene.domain.size[0] * scene.domain.size[1] / static_cast<double>(bins);
    for (std::size_t sample = 0; sample < fields.time.size(); ++sample) {
      double particles = 0;
      for (std::size_t bin = 0; bin < bins; ++bin)
        particles += fields.value[(sample * bins + bin) * 4] * volume;
      keep_worst(worst, std::abs(particles - poured_by(subject, fields.time[sample])));
    }
  }
  Evidence evidence;
  evidence.kind = Expectation::at_most;
  evidence.value = worst;
  evidence.expected = 1;
  evidence.budget.systematic = 1e-6;
  evidence.budget.reason = "a particle that is due at the end of a step may come in the next; rounding";
  evidence.summary = "largest difference between the particles in the box and those that were to be poured";
  return evidence;
}
}  // namespace

std::vector<CheckInfo> heap_growth_checks() {
  return {{"heap-growth",
           "height of a growing heap against that of as many packed particles, with slope and kinks of the "
           "largest",
           "heap-height",
           {"free-surface"},
           true,
           {law::Parameter{"least-particles", "1", "of the smallest heap that is compared", 1, 1e12}},
           is_closed_heap,
           growth_evidence},
          {"source-rate",
           "particles in a closed box against those that its source was to pour",
           "",
           {"fields"},
           false,
           {},
           is_closed_heap,
           rate_evidence}};
}

}  // namespace sandglass
