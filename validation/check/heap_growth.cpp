#include "sim/base/error.hpp"
#include "validation/check/falling.hpp"
#include "validation/check/families.hpp"
#include "validation/check/heap_profile.hpp"
#include "validation/check/heap_shape.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

// How a heap grows: heights and widths of all smaller heaps from the shape of the largest, and how much has been poured.

namespace sandglass {

namespace {
using Replicas = std::span<const std::size_t>;

/// What HeapProfile::height() gives of the law: integral of h^2 is 2 h_m^3/(3m) + (l/r) h_m^2, from 2 h x dh.
double height_of(const law::Heap& heap) {
  const double square = heap.height * heap.height * (2 * heap.height / (3 * heap.slope) + heap.kink_length);
  return 1.5 * square / law::heap_area(heap);
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

/// Height over that of the law, area in proportion to the particles poured.
double height_ratio(const Subject& subject, std::size_t sample, std::size_t last, Replicas replicas) {
  const HeapProfile large = heap_profile(subject, last, replicas);
  const HeapPoints points = below_head(large);
  law::Heap heap = fit_kinked_heap(points.x, points.h).heap;
  const double share = particles_at(subject, sample) / particles_at(subject, last);
  heap.height = law::heap_height(large.area() * share, heap.slope, heap.kink_length);
  return heap_profile(subject, sample, replicas).height() / height_of(heap);
}

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

/// Half an edge of a cell for the height of either heap, as no method of cells knows a place better.
double height_budget(const Subject& subject, const std::vector<std::size_t>& samples) {
  std::vector<double> heights;
  std::vector<std::size_t> replicas(subject.replicas());
  std::iota(replicas.begin(), replicas.end(), std::size_t{0});
  for (const std::size_t sample : {samples.front(), samples.back()})
    heights.push_back(heap_profile(subject, sample, replicas).height());
  return cell_edge(subject) / 2 * std::abs(1 / heights[0] - 1 / heights[1]);
}

Evidence growth_evidence(const Subject& subject, const law::Arguments& numbers) {
  const std::vector<std::size_t> samples = growing_samples(subject, numbers.at("least-particles"));
  WorstRatio worst;
  Figure heights{"Height of the growing heap over the law", {"particles", "1"}, {"ratio", "1"}, {}, {}};
  Figure::Points points{"measured", {}, {}, {}, {}};
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Mean ratio = jackknife(subject.replicas(), [&](Replicas replicas) {
      return height_ratio(subject, samples[i], samples.back(), replicas);
    });
    const double particles = particles_at(subject, samples[i]);
    worst.offer(ratio, fmt::format("{:.0f} particles", particles));
    points.x.push_back(particles), points.y.push_back(ratio.value);
    points.error.push_back(ratio.standard_error), points.expected.push_back(1);
  }
  Evidence evidence = worst.evidence();
  evidence.budget.systematic = height_budget(subject, samples);
  evidence.budget.reason = "half an edge of a cell in the heights of the smallest heap and the largest";
  evidence.summary =
      "height of the smaller heaps over that which the shape of the largest gives; worst: " + worst.label();
  heights.points.push_back(std::move(points));
  evidence.figures = {std::move(heights), collapse_figure(subject, samples)};
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
           "height of a growing heap against the law, with the shape of the largest",
           "heap-height",
           {"free-surface"},
           true,
           {law::Parameter{"least-particles", "1", "of the smallest heap that is compared", 1, 1e12, 100}},
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
