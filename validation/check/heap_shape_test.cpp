#include "validation/check/heap_shape.hpp"

#include "sim/base/error.hpp"
#include "validation/check/least_squares.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sandglass::heap_shape_test {
namespace {

struct Surface {
  std::vector<double> x, h;
};

/// Bins of width one where the heap stands above half a grain, with independent errors.
Surface surface_of(const law::Heap& heap, double error, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  Surface surface;
  for (double x = -200; x <= 200; ++x) {
    const double h = law::heap_surface(heap, x - 3.3);
    if (h < 0.5) continue;
    surface.x.push_back(x);
    surface.h.push_back(h + error * normal(generator));
  }
  return surface;
}

constexpr law::Heap kKinked{.height = 40, .slope = 0.4, .kink_length = 6};
constexpr law::Heap kTriangle{.height = 40, .slope = 0.4, .kink_length = 0};

TEST(LeastSquares, FindsParametersAndTheirErrors) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal;
  double spread = 0;
  constexpr int runs = 400;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> x, y;
    for (int i = 0; i < 60; ++i) {
      x.push_back(i / 20.0);
      y.push_back(2 * std::exp(-1.5 * x.back()) + 0.05 * normal(generator));
    }
    const LeastSquares fit = least_squares(
        [](std::span<const double> p, double at) { return p[0] * std::exp(-p[1] * at); }, {1, 1}, x, y);
    spread += std::pow((fit.parameters[1] - 1.5) / fit.errors[1], 2) / runs;
  }
  EXPECT_NEAR(spread, 1, 5 * std::sqrt(2.0 / runs));
}

TEST(HeapShape, FindsTheHeapThatDrewIt) {
  std::mt19937_64 generator(2);
  const Surface surface = surface_of(kKinked, 0.5, generator);
  const HeapFit fit = fit_kinked_heap(surface.x, surface.h);
  EXPECT_NEAR(fit.heap.height, 40, 4 * fit.error.height);
  EXPECT_NEAR(fit.heap.slope, 0.4, 4 * fit.error.slope);
  EXPECT_NEAR(fit.heap.kink_length, 6, 4 * fit.error.kink_length);
  EXPECT_NEAR(fit.centre, 3.3, 4 * fit.centre_error);
  EXPECT_LT(fit.error.kink_length, 1);
  EXPECT_NEAR(fit.mean_square, 0.25, 0.25 * 4 * std::sqrt(2 / static_cast<double>(surface.x.size())));
}

TEST(HeapShape, FindsATriangle) {
  std::mt19937_64 generator(3);
  const Surface surface = surface_of(kTriangle, 0.5, generator);
  const HeapFit fit = fit_triangle(surface.x, surface.h);
  EXPECT_NEAR(fit.heap.height, 40, 4 * fit.error.height);
  EXPECT_NEAR(fit.heap.slope, 0.4, 4 * fit.error.slope);
  EXPECT_EQ(fit.heap.kink_length, 0);
}

TEST(HeapShape, ComparisonChoosesTheShapeThatDrewIt) {
  std::mt19937_64 generator(4);
  const Surface kinked = surface_of(kKinked, 0.5, generator),
                triangle = surface_of(kTriangle, 0.5, generator);
  const ShapeComparison for_kinks = compare_shapes(kinked.x, kinked.h, 10, 4);
  EXPECT_GT(for_kinks.advantage.value, 4 * for_kinks.advantage.standard_error);
  const ShapeComparison for_triangle = compare_shapes(triangle.x, triangle.h, 10, 4);
  EXPECT_LT(for_triangle.advantage.value, 2 * for_triangle.advantage.standard_error);
}

TEST(HeapShape, RefusesTooFewPoints) {
  const std::vector<double> x{1, 2, 3}, h{1, 2, 1};
  EXPECT_THROW(fit_triangle(x, h), InputError);
  EXPECT_THROW(compare_shapes(x, h, 10, 2), InputError);
}

}  // namespace
}  // namespace sandglass::heap_shape_test
