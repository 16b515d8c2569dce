#include "validation/law/virial.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"

#include <array>
#include <limits>

namespace sandglass::law {

namespace {
constexpr int kOrder = 9;  // of the polynomial: B_2 to B_10

/// Standard errors of B_k / B_2^(k-1), k = 2..10: Clisby & McCoy (2006) table 1, rounding of B_3 and B_4.
constexpr std::array<double, 9> kDiskErrors = {0, 5e-9, 5e-9, 1e-8, 42e-7, 43e-7, 34e-7, 35e-7, 80e-7};
constexpr std::array<double, 9> kSphereErrors = {0, 0, 5e-9, 1e-6, 91e-8, 91e-8, 11e-7, 13e-7, 15e-7};

double power(double base, int exponent) {
  double product = 1;
  for (int i = 0; i < exponent; ++i) product *= base;
  return product;
}

/// Coefficient of nu^k in Z: 1 for k = 0, else B_(k+1) in units of the particle's volume.
double series_coefficient(int dimension, int k) {
  return k == 0 ? 1 : virial_ratio(dimension, k + 1) * power(dimension == 2 ? 2 : 4, k);
}

/// Coefficient of nu^k in (1-nu)^D Z.
double rescaled_coefficient(int dimension, int k) {
  constexpr std::array<std::array<double, 4>, 2> binomial = {{{1, -2, 1, 0}, {1, -3, 3, -1}}};
  double sum = 0;
  for (int j = 0; j <= dimension && j <= k; ++j)
    sum += binomial[static_cast<std::size_t>(dimension - 2)][static_cast<std::size_t>(j)] *
           series_coefficient(dimension, k - j);
  return sum;
}

/// Standard error of the truncated (1-nu)^D Z: each B enters at its own order and, times the binomials, above.
double coefficient_error(int dimension, double fraction) {
  const auto& errors = dimension == 2 ? kDiskErrors : kSphereErrors;
  const double excluded = (dimension == 2 ? 2 : 4) * fraction;
  double square = 0;
  for (int k = 2; k <= 10; ++k)
    square += power(errors[static_cast<std::size_t>(k - 2)] * power(excluded, k - 1), 2);
  return std::sqrt(square);  // the factor (1-nu)^D, cut at the last order, is at most 1
}

constexpr double kHighestDisks = 0.66, kHighestVirialDisks = 0.60, kHighestSpheres = 0.49;
constexpr double kLudingError = 0.002;

Bounded luding_contact_value(double fraction) {
  const double value = contact_value(2, fraction) - power(fraction, 3) / (128 * power(1 - fraction, 4));
  return {value, 0, kLudingError * value};
}
}  // namespace

Bounded virial_compressibility(int dimension, double fraction) {
  const double room = power(1 - fraction, dimension);
  double sum = 0;
  for (int k = kOrder; k >= 0; --k) sum = sum * fraction + rescaled_coefficient(dimension, k);
  const double last = rescaled_coefficient(dimension, kOrder) * power(fraction, kOrder);
  return {sum / room, coefficient_error(dimension, fraction) / room, std::abs(last) / room};
}

Bounded reference_contact_value(int dimension, double fraction) {
  if (fraction == 0) return {1, 0, 0};
  if (fraction > (dimension == 2 ? kHighestDisks : kHighestSpheres)) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown};
  }
  if (dimension == 2 && fraction > kHighestVirialDisks) return luding_contact_value(fraction);
  const Bounded z = virial_compressibility(dimension, fraction);
  const double excluded = (dimension == 2 ? 2 : 4) * fraction;
  return {(z.value - 1) / excluded, z.standard_error / excluded, z.bound / excluded};
}

Bounded reference_compressibility(const Gas& gas) {
  const Bounded g = reference_contact_value(gas.dimension, gas.fraction);
  const double factor = excluded_fraction(gas) * (1 + gas.restitution) / 2;
  return {1 + factor * g.value, factor * g.standard_error, factor * g.bound};
}

Bounded reference_collision_rate(const Gas& gas) {
  const Bounded g = reference_contact_value(gas.dimension, gas.fraction);
  const double per_contact = collision_rate(gas) / contact_value(gas.dimension, gas.fraction);
  return {per_contact * g.value, per_contact * g.standard_error, per_contact * g.bound};
}

}  // namespace sandglass::law
