#pragma once

#include "sim/base/statistics.hpp"
#include "validation/law/heap.hpp"

#include <span>

namespace sandglass {

/// Diameters that l/r may have: a grain, over a probability to stop of a tenth.
constexpr double kMostKink = 10;

/// Surface of a heap fitted by the law of kinks (3.17) or by a triangle.
struct HeapFit {
  law::Heap heap{};   ///< kink_length 0 for a triangle
  law::Heap error{};  ///< one standard error of each, as if the points were independent
  double centre = 0, centre_error = 0;
  double mean_square = 0;  ///< of the residuals of h [length^2]
};

/// `x` and `h` of the surface, both sides, where it is above the floor. Throws InputError when the fit does not settle.
HeapFit fit_kinked_heap(std::span<const double> x, std::span<const double> h);
HeapFit fit_triangle(std::span<const double> x, std::span<const double> h);

/// The two against each other by what they predict of points that they were not fitted to. The points are cut into
/// `folds` times `stretches` neighbouring stretches; each fold leaves out every folds-th of them, so that the correlation
/// of neighbours does not decide. Ten folds of four stretches or so: with many, folds are alike and their scatter is small.
struct ShapeComparison {
  Mean advantage;  ///< mean square residual of the triangle less that of the kinks, over folds [length^2]
  HeapFit kinked, triangle;
};
ShapeComparison compare_shapes(std::span<const double> x, std::span<const double> h, std::size_t folds,
                               std::size_t stretches);

}  // namespace sandglass
