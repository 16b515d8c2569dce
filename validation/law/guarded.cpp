#include "validation/law/guarded.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"

#include <algorithm>
#include <array>

#include <gsl/gsl_sf_bessel.h>

namespace sandglass::law {

namespace {
constexpr double kFitted = 1.2;  // collisions in the contact time
constexpr double kStep = 0.1;    // of the trapezoidal rule; integrands are smooth and Gaussian
constexpr int kHalf = 55;        // out to 5.5 sqrt(2T/m)
using Line = std::array<double, 2 * kHalf + 1>;

/// exp(-x rate) of a particle with the given speed along the contact normal, averaged over the rest.
double survival(int dimension, double x, double along) {
  double sum = 0, weight = 0;
  for (int i = 0; i <= kHalf; ++i) {
    const double across = i * kStep;
    const double ends = dimension == 2 ? (i == 0 ? 0.5 : 1) : across;
    const double gaussian = ends * std::exp(-across * across);
    weight += gaussian;
    sum += gaussian * std::exp(-x * speed_resolved_rate(dimension, std::hypot(along, across)));
  }
  return sum / weight;
}

/// Sum of phi(u) phi(v) (u-v)^3 f(u) f(v) over u > v on the grid.
double loss(const Line& factor) {
  double sum = 0;
  for (int i = -kHalf; i <= kHalf; ++i)
    for (int j = -kHalf; j < i; ++j) {
      const double u = i * kStep, v = j * kStep, approach = u - v;
      sum += std::exp(-u * u - v * v) * approach * approach * approach *
             factor[static_cast<std::size_t>(i + kHalf)] * factor[static_cast<std::size_t>(j + kHalf)];
    }
  return sum;
}
}  // namespace

double speed_resolved_rate(int dimension, double s) {
  const double square = s * s;
  if (dimension == 2)
    return ((1 + square) * gsl_sf_bessel_I0_scaled(square / 2) +
            square * gsl_sf_bessel_I1_scaled(square / 2)) /
           std::numbers::sqrt2;
  const double rise = s < 1e-4 ? 1 : (s + 0.5 / s) * std::sqrt(std::numbers::pi) * std::erf(s);
  return (std::exp(-square) + rise) / (2 * std::numbers::sqrt2);
}

double guarded_share(int dimension, double x) {
  Line all, left;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const auto at = static_cast<std::size_t>(i + kHalf);
    all[at] = 1;
    left[at] = survival(dimension, x, std::abs(i) * kStep);
  }
  return loss(left) / loss(all);
}

double guarded_share_polynomial(double x) {
  const double y = std::sqrt(std::numbers::pi) * x;
  return std::exp(-1.268 * y + 0.01682 * y * y - 0.0005783 * y * y * y);
}

Bounded guarded_share_of_contacts(const Gas& gas, double x) {
  const double share = guarded_share(gas.dimension, x), known = std::min(x, kFitted);
  const double more = 0.125 * known - 0.026 * known * known;
  const bool is_fitted = gas.dimension == 2 && gas.fraction > 0.2 && gas.fraction < 0.67 && x <= kFitted;
  if (!is_fitted) return {share * std::exp(more / 2), 0, share * more / 2};
  return {share * std::exp(more), 0, share * (gas.fraction > 0.55 ? 0.003 : 0.01)};
}

double guarded_cooling_rate(const Gas& gas, double contact_time) {
  return cooling_rate(gas) * guarded_share(gas.dimension, collision_rate(gas) * contact_time);
}

}  // namespace sandglass::law
