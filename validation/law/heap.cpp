#include "validation/law/heap.hpp"

#include <algorithm>
#include <cmath>

#include <gsl/gsl_sf_lambert.h>

namespace sandglass::law {

namespace {
/// w of w + ln w = s. Lambert's W(e^s), and Newton's method where e^s would overflow.
double wright_omega(double s) {
  if (s < 500) return gsl_sf_lambert_W0(std::exp(s));
  double w = s - std::log(s);
  for (int i = 0; i < 4; ++i) w -= (w + std::log(w) - s) / (1 + 1 / w);
  return w;
}
}  // namespace

double heap_distance(const Heap& heap, double h) {
  return (heap.height - h) / heap.slope + heap.kink_length * std::log(heap.height / h);
}

double heap_surface(const Heap& heap, double distance) {
  const double x = std::abs(distance), unit = heap.slope * heap.kink_length;
  if (unit == 0) return std::max(heap.height - heap.slope * x, 0.0);
  const double top = heap.height / unit;
  return unit * wright_omega(top + std::log(top) - x / heap.kink_length);
}

double heap_area(const Heap& heap) { return heap.height * (heap.height / heap.slope + 2 * heap.kink_length); }

double heap_height(double area, double slope, double kink_length) {
  return area / (kink_length + std::sqrt(kink_length * kink_length + area / slope));
}

}  // namespace sandglass::law
