#pragma once

#include "validation/check/subject.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// Surface of a heap under a source: middles of the bins of `free-surface` and heights, mean over some replicas.
struct HeapProfile {
  std::vector<double> x;  ///< from below the source, in order
  std::vector<double> h;
  double bin = 0;       ///< width
  double diameter = 0;  ///< of a particle

  double area() const;
  double width() const { return bin * static_cast<double>(x.size()); }  ///< of the box
  /// 3/2 of the integral of h^2 over that of h: the height of a triangle, without a say of single bins.
  double height() const;
  /// Half of the base of the triangle of this area and height.
  double half_base() const { return area() / height(); }
  /// Lower than a particle.
  bool is_bare() const { return !(area() > 0) || height() < diameter; }
};

/// The sample is one of `free-surface`. Throws InputError where the scene is not that of a heap (is_heap).
///
/// While particles come, the highest in a bin may be one that still falls or rebounds. Rebounds stand over a bin for a
/// moment: in each replica the height is the median over the samples of ten particles before and after. Over the source
/// there is always one that falls: there the surface is the mean of both sides, until the last has been poured.
HeapProfile heap_profile(const Subject& subject, std::size_t sample, std::span<const std::size_t> replicas);

/// The surface from the head, of which the law does not speak, to twice half the base. Bare floor counts: who lies on it
/// alone must not pass for a tail.
struct HeapPoints {
  std::vector<double> x, h;
};
HeapPoints below_head(const HeapProfile& profile);

/// The straight part of a side, in parts of half the base: neither the head nor the tail.
constexpr double kStraightFrom = 0.2, kStraightTo = 0.7;

/// Least-squares slope of the surface, falling outwards, where `from` <= |x| <= `to` on both sides, or on one: -1 is left,
/// 1 right. Bins count by their part of the range, so that no bin comes or goes at once when the range moves a little (a
/// jackknife would take that for bias). NaN on less than two bins of a side.
double heap_slope(const HeapProfile& profile, double from, double to);
double heap_side_slope(const HeapProfile& profile, int side, double from, double to);

/// Samples of `free-surface` at or after a time. Throws InputError when there is none.
std::size_t heap_sample_at(const Subject& subject, double time);
/// When the source has poured all of its particles; the end of the run without a count.
double end_of_pouring(const Subject& subject);
/// Particles that have been poured at a time.
double poured_by(const Subject& subject, double time);

/// Two dimensions, one source at a height above the pile, gravity down along y.
bool is_heap(const Scene& scene);
/// is_heap, on a plane between walls: nobody leaves.
bool is_closed_heap(const Scene& scene);

}  // namespace sandglass
