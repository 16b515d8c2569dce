#include "validation/law/obstructed_column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass::law {

namespace {
constexpr int kParts = 200;  // of Simpson's rule over an obstacle; the integrand is smooth

double per_height(const Column& column) { return column.mass * column.gravity / column.temperature; }

/// Integral of exp(-z rate) over what lies below z in a column without obstacles, per area.
double below(double rate, double z) { return rate == 0 ? z : -std::expm1(-rate * z) / rate; }

/// The same over an obstacle; z = centre + radius sin(angle), so that its edges are smooth.
double inside(const RoundObstacle& obstacle, int dimension, double rate, double z) {
  const double radius = obstacle.radius;
  if (radius == 0) return 0;
  const double top = std::asin(std::clamp((z - obstacle.height) / radius, -1.0, 1.0));
  const double low = -std::numbers::pi / 2, step = (top - low) / kParts;
  double sum = 0;
  for (int i = 0; i <= kParts; ++i) {
    const double angle = low + i * step, half = radius * std::cos(angle);
    const double section = dimension == 2 ? 2 * half : std::numbers::pi * half * half;
    const double weight = i == 0 || i == kParts ? 1 : (i % 2 == 0 ? 2 : 4);
    sum += weight * section * half * std::exp(-rate * (obstacle.height + radius * std::sin(angle)));
  }
  return sum * step / 3;
}

double free_part_below(const ObstructedColumn& column, double z) {
  const double rate = per_height(column.column);
  double sum = column.area * below(rate, std::clamp(z, 0.0, column.column.height));
  for (const RoundObstacle& obstacle : column.obstacles) sum -= inside(obstacle, column.dimension, rate, z);
  return sum;
}
}  // namespace

double obstructed_fraction(const ObstructedColumn& column, double z) {
  return free_part_below(column, z) / free_part_below(column, column.column.height);
}

double floor_force(const ObstructedColumn& column) {
  return column.column.temperature * column.area / free_part_below(column, column.column.height);
}

double lid_force(const ObstructedColumn& column) {
  return floor_force(column) * std::exp(-per_height(column.column) * column.column.height);
}

}  // namespace sandglass::law
