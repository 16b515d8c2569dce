#include "validation/check/heap_shape.hpp"

#include "sim/base/error.hpp"
#include "validation/check/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

namespace {
// Parameters: centre, then the logarithms of height, slope and, with kinks, kink length, all of which are positive.
law::Heap heap_of(std::span<const double> parameters) {
  return {std::exp(parameters[1]), std::exp(parameters[2]),
          parameters.size() > 3 ? std::exp(parameters[3]) : 0.0};
}

double surface(std::span<const double> parameters, double x) {
  return law::heap_surface(heap_of(parameters), x - parameters[0]);
}

struct Points {
  std::vector<double> x, h;
};

/// Highest point, and the triangle of the same area.
std::vector<double> start_of(const Points& points) {
  const auto top = std::max_element(points.h.begin(), points.h.end());
  if (points.x.size() < 8 || !(*top > 0))
    throw InputError("a heap needs a surface of eight points or more: narrow the bins of the observer");
  const double mean =
      std::accumulate(points.h.begin(), points.h.end(), 0.0) / static_cast<double>(points.h.size());
  const auto [low, high] = std::minmax_element(points.x.begin(), points.x.end());
  return {points.x[static_cast<std::size_t>(top - points.h.begin())], std::log(*top),
          std::log(*top * *top / (mean * (*high - *low)))};
}

LeastSquares fit_points(const Points& points, bool kinked) {
  LeastSquares fit = least_squares(surface, start_of(points), points.x, points.h);
  if (!kinked) return fit;
  std::vector<double> start = fit.parameters;
  start.push_back(start[1] - start[2] - std::log(20.0));  // a twentieth of the half width
  return least_squares(surface, std::move(start), points.x, points.h);
}

HeapFit heap_fit(const LeastSquares& fit) {
  HeapFit result;
  result.heap = heap_of(fit.parameters);
  result.error = {result.heap.height * fit.errors[1], result.heap.slope * fit.errors[2],
                  fit.errors.size() > 3 ? result.heap.kink_length * fit.errors[3] : 0.0};
  result.centre = fit.parameters[0];
  result.centre_error = fit.errors[0];
  result.mean_square = fit.mean_square;
  return result;
}

/// The points of a fold, left out or kept.
Points fold_of(const Points& all, std::size_t fold, std::size_t folds, std::size_t stretches, bool left_out) {
  Points part;
  const std::size_t count = all.x.size(), pieces = folds * stretches;
  for (std::size_t i = 0; i < count; ++i) {
    if ((i * pieces / count % folds == fold) != left_out) continue;
    part.x.push_back(all.x[i]);
    part.h.push_back(all.h[i]);
  }
  return part;
}

double prediction_error(const Points& all, std::size_t fold, std::size_t folds, std::size_t stretches,
                        bool kinked) {
  const LeastSquares fit = fit_points(fold_of(all, fold, folds, stretches, false), kinked);
  const Points out = fold_of(all, fold, folds, stretches, true);
  return mean_square_residual(surface, fit.parameters, out.x, out.h);
}

Points points_of(std::span<const double> x, std::span<const double> h) {
  SANDGLASS_EXPECT(x.size() == h.size());
  return {{x.begin(), x.end()}, {h.begin(), h.end()}};
}
}  // namespace

HeapFit fit_kinked_heap(std::span<const double> x, std::span<const double> h) {
  return heap_fit(fit_points(points_of(x, h), true));
}

HeapFit fit_triangle(std::span<const double> x, std::span<const double> h) {
  return heap_fit(fit_points(points_of(x, h), false));
}

ShapeComparison compare_shapes(std::span<const double> x, std::span<const double> h, std::size_t folds,
                               std::size_t stretches) {
  if (folds < 2 || x.size() < 2 * folds * stretches)
    throw InputError(fmt::format("{} points of a surface cannot be cut into {} folds of {} stretches",
                                 x.size(), folds, stretches));
  const Points points = points_of(x, h);
  std::vector<double> advantages;
  for (std::size_t fold = 0; fold < folds; ++fold)
    advantages.push_back(prediction_error(points, fold, folds, stretches, false) -
                         prediction_error(points, fold, folds, stretches, true));
  return {mean_of_independent(advantages), fit_kinked_heap(x, h), fit_triangle(x, h)};
}

}  // namespace sandglass
