#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/heap_profile.hpp"
#include "validation/check/heap_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

// A heap that is poured on a floor: slope of its sides, head, tail and what a table's edge does (Mueller 2001, 3.5).

namespace sandglass {

namespace {
constexpr std::size_t kFolds = 10;

using Replicas = std::span<const std::size_t>;

HeapProfile all_replicas(const Subject& subject, std::size_t sample) {
  std::vector<std::size_t> replicas(subject.replicas());
  std::iota(replicas.begin(), replicas.end(), std::size_t{0});
  return heap_profile(subject, sample, replicas);
}

std::size_t last_sample(const Subject& subject) { return subject.series(0, "free-surface").time.size() - 1; }

/// 0 where the particles lie in less than a layer on the floor.
double straight_slope(const HeapProfile& profile) {
  if (profile.is_bare()) return 0;
  return heap_slope(profile, kStraightFrom * profile.half_base(), kStraightTo * profile.half_base());
}

double straight_slope(const HeapProfile& profile, int side) {
  if (profile.is_bare()) return 0;
  return heap_side_slope(profile, side, kStraightFrom * profile.half_base(),
                         kStraightTo * profile.half_base());
}

Figure surface_figure(const Subject& subject, std::size_t sample) {
  const HeapProfile profile = all_replicas(subject, sample);
  Figure figure{"Surface of the heap", {"distance from the source", "length"}, {"height", "length"}, {}, {}};
  Figure::Points points{"mean of the replicas", profile.x, profile.h, {}, {}};
  for (std::size_t bin = 0; bin < profile.x.size(); ++bin) {
    std::vector<double> heights;
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
      const std::size_t one[] = {replica};
      heights.push_back(heap_profile(subject, sample, one).h[bin]);
    }
    points.error.push_back(mean_of_independent(heights).standard_error);
  }
  figure.points.push_back(std::move(points));
  return figure;
}

void add_line(Figure& figure, const HeapProfile& profile, const std::string& name, const law::Heap& heap,
              double centre) {
  Figure::Line line{name, profile.x, {}};
  for (const double x : profile.x) line.y.push_back(law::heap_surface(heap, x - centre));
  figure.lines.push_back(std::move(line));
}

ShapeComparison shapes_of(const HeapProfile& profile) {
  const HeapPoints points = below_head(profile);
  // Up to four stretches a fold, of two points at least: the more, the less one fold differs from the next.
  const std::size_t stretches = std::clamp<std::size_t>(points.x.size() / (2 * kFolds), 1, 4);
  return compare_shapes(points.x, points.h, kFolds, stretches);
}

/// The mean surface with both shapes, where they fit.
Figure tail_figure(const Subject& subject, std::size_t sample) {
  Figure figure = surface_figure(subject, sample);
  const HeapProfile profile = all_replicas(subject, sample);
  try {
    const ShapeComparison shapes = shapes_of(profile);
    add_line(figure, profile, "(3.17)", shapes.kinked.heap, shapes.kinked.centre);
    add_line(figure, profile, "triangle", shapes.triangle.heap, shapes.triangle.centre);
  } catch (const InputError&) {
  }
  return figure;
}

Mean slope_at_end(const Subject& subject) {
  return jackknife(subject.replicas(), [&](Replicas replicas) {
    return straight_slope(heap_profile(subject, last_sample(subject), replicas));
  });
}

Evidence slope_evidence(const Subject& subject, const law::Arguments& numbers) {
  const std::size_t sample = last_sample(subject);
  const auto slope = [&](int side) {
    return jackknife(subject.replicas(), [&](Replicas replicas) {
      return straight_slope(heap_profile(subject, sample, replicas), side);
    });
  };
  const Mean left = slope(-1), right = slope(1);
  Evidence evidence = at_least(slope_at_end(subject), numbers.at("least"));
  evidence.summary = fmt::format(
      "slope of the straight part of both sides at the end; left {:.3f} ± {:.3f}, right {:.3f} ± {:.3f}",
      left.value, left.standard_error, right.value, right.standard_error);
  evidence.figures.push_back(surface_figure(subject, sample));
  return evidence;
}

/// A staircase of preferred slopes would stand apart from the curve.
Evidence curve_evidence(const Subject& subject, const law::Arguments& numbers) {
  Evidence evidence = from_mean(slope_at_end(subject), numbers.at("expected"));
  evidence.budget.reference = numbers.at("expected-error");
  evidence.summary =
      "slope of the straight part at the end, beside a smooth curve through those at other restitutions";
  return evidence;
}

Evidence head_evidence(const Subject& subject, const law::Arguments& numbers) {
  const std::size_t sample = last_sample(subject);
  const Mean flatter = jackknife(subject.replicas(), [&](Replicas replicas) {
    const HeapProfile profile = heap_profile(subject, sample, replicas);
    return straight_slope(profile) - heap_slope(profile, 0, kStraightFrom * profile.half_base());
  });
  Evidence evidence = at_least(flatter, numbers.at("least"));
  evidence.summary = "slope of the straight part less that of the head";
  evidence.figures.push_back(surface_figure(subject, sample));
  return evidence;
}

/// Mean over all samples after the pouring.
HeapProfile late_profile(const Subject& subject, Replicas replicas) {
  const std::size_t first = heap_sample_at(subject, end_of_pouring(subject)), last = last_sample(subject);
  HeapProfile mean = heap_profile(subject, first, replicas);
  for (std::size_t sample = first + 1; sample <= last; ++sample) {
    const HeapProfile other = heap_profile(subject, sample, replicas);
    for (std::size_t bin = 0; bin < mean.h.size(); ++bin) mean.h[bin] += other.h[bin];
  }
  for (double& h : mean.h) h /= static_cast<double>(last - first + 1);
  return mean;
}

/// In parts of half the table, so that the outer part ends at its edge.
Evidence edge_evidence(const Subject& subject, const law::Arguments&) {
  const double half = subject.scene().domain.size[0] / 2;
  const Mean ratio = jackknife(subject.replicas(), [&](Replicas replicas) {
    const HeapProfile profile = late_profile(subject, replicas);
    return heap_slope(profile, 0.6 * half, half) / heap_slope(profile, 0.2 * half, 0.6 * half);
  });
  Evidence evidence = at_least(ratio, 1);
  evidence.summary = "slope of the outer two fifths of a table over that of the middle two fifths of a side";
  evidence.figures.push_back(surface_figure(subject, last_sample(subject)));
  return evidence;
}

/// At the end of pouring: the law is that of a heap that grows. Each replica by itself: a mean of triangles whose feet
/// differ has a tail of its own. A kink is of the size of a grain and no probability above one, so that l/r is a diameter
/// or more; of a layer without sides it is as long as the layer. Where no shape fits: not a number.
Evidence tail_evidence(const Subject& subject, const law::Arguments&) {
  const std::size_t sample = heap_sample_at(subject, end_of_pouring(subject));
  std::vector<double> kinks, advantages;
  Evidence evidence;
  try {
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
      const ShapeComparison shapes = shapes_of(heap_profile(subject, sample, std::span(&replica, 1)));
      kinks.push_back(shapes.kinked.heap.kink_length);
      advantages.push_back(shapes.advantage.value);
    }
    const Mean advantage = mean_of_independent(advantages);
    evidence = from_mean(mean_of_independent(kinks), subject.species().diameter);
    evidence.summary = fmt::format(
        "l/r of each replica at the end of pouring; mean square residual of a triangle less that of (3.17), "
        "of "
        "points left out of the fit: {:.3f} ± {:.3f}",
        advantage.value, advantage.standard_error);
  } catch (const InputError& error) {
    evidence.value = std::numeric_limits<double>::quiet_NaN();
    evidence.summary = std::string("no shape fits: ") + error.what();
  }
  evidence.kind = Expectation::between;
  evidence.expected = subject.species().diameter;
  evidence.upper = kMostKink * subject.species().diameter;
  evidence.units = "length";
  evidence.figures.push_back(tail_figure(subject, sample));
  return evidence;
}

/// Of the mean surface.
Evidence spike_evidence(const Subject& subject, const law::Arguments& numbers) {
  const Mean width = jackknife(subject.replicas(), [&](Replicas replicas) {
    const HeapProfile profile = heap_profile(subject, last_sample(subject), replicas);
    const double half = *std::ranges::max_element(profile.h) / 2;
    const auto high = std::ranges::count_if(profile.h, [&](double h) { return h > half; });
    return static_cast<double>(high) * profile.bin / numbers.at("cell");
  });
  Evidence evidence = from_mean(width, numbers.at("least"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("most");
  evidence.summary = "width of the surface at half of its height, in cells";
  evidence.figures.push_back(surface_figure(subject, last_sample(subject)));
  return evidence;
}

bool is_heap_on_table(const Scene& scene) {
  return is_heap(scene) && scene.domain.sides[0] == std::array{Side::open, Side::open};
}

CheckInfo heap_check(std::string name, std::string summary, std::string law,
                     std::vector<law::Parameter> parameters, std::function<bool(const Scene&)> applies,
                     std::function<Evidence(const Subject&, const law::Arguments&)> evaluate) {
  return {std::move(name), std::move(summary),    std::move(law),     {"free-surface"},
          false,           std::move(parameters), std::move(applies), std::move(evaluate)};
}
}  // namespace

std::vector<CheckInfo> heap_checks() {
  using law::Parameter;
  return {
      heap_check("heap-slope", "slope of the straight part of a heap at the end", "",
                 {Parameter{"least", "1", "slope below which it is no heap", 0, 10}}, is_heap,
                 slope_evidence),
      heap_check("heap-slope-curve",
                 "slope of a heap at the end against a smooth curve through those at other restitutions", "",
                 {Parameter{"expected", "1", "slope that the curve gives here", 0, 10},
                  Parameter{"expected-error", "1", "its standard error", 0, 10}},
                 is_heap, curve_evidence),
      heap_check("heap-head", "slope of the straight part of a heap less that of its head", "",
                 {Parameter{"least", "1", "by which the head is flatter", 0, 10}}, is_heap, head_evidence),
      heap_check("heap-edge", "slope of a heap on a table near the edge over that further in", "", {},
                 is_heap_on_table, edge_evidence),
      heap_check("heap-tail", "logarithmic tail of a heap against a triangle", "heap-surface", {},
                 is_closed_heap, tail_evidence),
      heap_check("heap-spike", "width of a heap at half of its height, in cells", "",
                 {Parameter{"cell", "length", "edge of a collision cell", 1e-12, 1e12},
                  Parameter{"least", "1", "cells", 0, 1e6}, Parameter{"most", "1", "cells", 0, 1e6}},
                 is_heap, spike_evidence)};
}

}  // namespace sandglass
