#include "validation/law/heap.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::law::heap_test {
namespace {

constexpr Heap kHeap{.height = 40, .slope = 0.4, .kink_length = 3};

// Mueller (3.16), dh/dx = -m/(1 + l m/(r h)), by fourth-order Runge-Kutta steps.
TEST(Heap, SurfaceSolvesTheEquationOfItsKinks) {
  const auto fall = [](double h) { return -0.4 / (1 + 3 * 0.4 / h); };
  const double step = 0.01;
  double h = kHeap.height;
  for (int i = 1; i <= 20000; ++i) {
    const double a = fall(h), b = fall(h + step / 2 * a), c = fall(h + step / 2 * b), d = fall(h + step * c);
    h += step / 6 * (a + 2 * b + 2 * c + d);
    if (i % 1000 == 0) {
      EXPECT_NEAR(heap_surface(kHeap, i * step) / h, 1, 1e-9) << i * step;
    }
  }
}

TEST(Heap, SurfaceIsTheInverseOfTheDistance) {
  for (double kink : {1e-3, 0.1, 3.0, 200.0})
    for (double share : {1.0, 0.7, 0.1, 1e-3}) {
      const Heap heap{.height = 40, .slope = 0.4, .kink_length = kink};
      EXPECT_NEAR(heap_surface(heap, heap_distance(heap, 40 * share)) / (40 * share), 1, 1e-9);
      EXPECT_DOUBLE_EQ(heap_surface(heap, 17), heap_surface(heap, -17));
    }
}

TEST(Heap, AreaIsTheIntegralOfTheSurface) {
  const double far = heap_distance(kHeap, 1e-12);
  const double area = 2 * quadrature::integral([](double x) { return heap_surface(kHeap, x); }, 0, far);
  EXPECT_NEAR(heap_area(kHeap) / area, 1, 1e-9);
}

TEST(Heap, HeightIsThatOfItsArea) {
  for (double kink : {0.0, 1e-6, 3.0, 1e4}) {
    const Heap heap{.height = 40, .slope = 0.4, .kink_length = kink};
    EXPECT_NEAR(heap_height(heap_area(heap), 0.4, kink) / 40, 1, 1e-14);
  }
}

TEST(Heap, IsATriangleWithoutKinks) {
  const Heap triangle{.height = 40, .slope = 0.4, .kink_length = 0};
  const Heap nearly{.height = 40, .slope = 0.4, .kink_length = 1e-5};
  for (double x : {0.0, 30.0, 90.0, 120.0})
    EXPECT_NEAR(heap_surface(nearly, x), heap_surface(triangle, x), 1e-3);
  EXPECT_EQ(heap_surface(triangle, 101), 0);
  EXPECT_NEAR(heap_area(triangle), 40 * 100, 1e-11);
}

// Mueller (3.13): h/sqrt(A) is a function of x/sqrt(A) when l/r grows with sqrt(A), or for large heaps.
TEST(Heap, LargeHeapsFollowTheGrowthScaling) {
  const auto deviation = [](double area) {
    const double root = std::sqrt(area), height = heap_height(area, 0.4, 3);
    const Heap heap{.height = height, .slope = 0.4, .kink_length = 3};
    return heap_surface(heap, 0.5 * root) / root - (std::sqrt(0.4) - 0.4 * 0.5);
  };
  EXPECT_NEAR(deviation(4e8) / deviation(1e8), 0.5, 0.01);
  EXPECT_LT(std::abs(deviation(1e8)), 1e-3);
  EXPECT_NEAR(heap_height(1e-6, 0.4, 3) / (1e-6 / 6), 1, 1e-6);
}

}  // namespace
}  // namespace sandglass::law::heap_test
