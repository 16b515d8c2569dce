#include "validation/law/impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass::law {

using std::numbers::pi;

namespace {
constexpr double kSmall = 1e-3;  // series below: terms left out are of the order c^4

/// artanh(sqrt(c) b)/sqrt(c), real for either sign of c: the integral of 1/(1 - c b^2) from 0 to b.
double line_integral(double c, double b) {
  if (std::abs(c) < kSmall) {
    const double x = c * b * b;
    return b * (1 + x * (1.0 / 3 + x * (1.0 / 5 + x * (1.0 / 7 + x / 9))));
  }
  const double root = std::sqrt(std::abs(c));
  return (c > 0 ? std::atanh(root * b) : std::atan(root * b)) / root;
}

/// Inverse of line_integral in b.
double line_inverse(double c, double integral) {
  const double root = std::sqrt(std::abs(c));
  if (root * std::abs(integral) < 1e-9) return integral;
  return (c > 0 ? std::tanh(root * integral) : std::tan(root * integral)) / root;
}

/// -ln(1 - c s)/c, the integral of 1/(1 - c s) over s = b^2.
double disk_integral(double c, double s) {
  return std::abs(c * s) < 1e-9 ? s * (1 + c * s / 2) : -std::log1p(-c * s) / c;
}

double disk_inverse(double c, double integral) {
  return std::abs(c * integral) < 1e-9 ? integral * (1 - c * integral / 2) : -std::expm1(-c * integral) / c;
}

/// <b^2>: the integrals of b^2/(1 - c b^2) and 1/(1 - c b^2) differ by that of 1.
double mean_square(int dimension, double c) {
  if (std::abs(c) < kSmall)
    return dimension == 2 ? 1.0 / 3 + c * (4.0 / 45 + c * (44.0 / 945 + c * 428.0 / 14175))
                          : 1.0 / 2 + c * (1.0 / 12 + c * (1.0 / 24 + c * 19.0 / 720));
  const double whole = dimension == 2 ? line_integral(c, 1) : disk_integral(c, 1);
  return (1 - 1 / whole) / c;
}
}  // namespace

double impact_normalisation(int dimension, double coefficient) {
  return dimension == 2 ? 1 / (2 * line_integral(coefficient, 1)) : 1 / (pi * disk_integral(coefficient, 1));
}

double impact_dissipation_ratio(int dimension, double coefficient) {
  return (1 - mean_square(dimension, coefficient)) * (dimension == 2 ? 3.0 / 2 : 2);
}

double impact_cumulative(int dimension, double coefficient, double b) {
  if (dimension == 2) {
    const double share = line_integral(coefficient, std::clamp(b, -1.0, 1.0)) / line_integral(coefficient, 1);
    return (1 + share) / 2;
  }
  const double inside = std::clamp(b, 0.0, 1.0);
  return disk_integral(coefficient, inside * inside) / disk_integral(coefficient, 1);
}

double impact_quantile(int dimension, double coefficient, double share) {
  if (dimension == 2)
    return std::clamp(line_inverse(coefficient, (2 * share - 1) * line_integral(coefficient, 1)), -1.0, 1.0);
  return std::sqrt(std::clamp(disk_inverse(coefficient, share * disk_integral(coefficient, 1)), 0.0, 1.0));
}

}  // namespace sandglass::law
