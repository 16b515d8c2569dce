#include "validation/law/vibrated_bed.hpp"

#include <cmath>
#include <numbers>

namespace sandglass::law {

using std::numbers::pi;

namespace {
double lost(double restitution) { return 1 - restitution * restitution; }

/// gain = linear x + quadratic x^2, each over N m g sqrt(m/T).
struct Balance {
  double gain, linear, quadratic;
};

Balance balance_of(const VibratedBed& bed) {
  const double contacts = bed.dimension == 2 ? std::sqrt(pi) / 2 : std::sqrt(pi);
  return {bottom_gain(bed.bottom_restitution) * bed.speed * bed.speed / 2,
          contacts * bed.layers * lost(bed.restitution) + lost(bed.bottom_restitution) / std::sqrt(2 * pi),
          (bed.dimension - 1) * std::sqrt(2 / pi) * lost(bed.side_restitution) / (bed.gravity * bed.width)};
}

double root_of(const Balance& balance) {
  const auto [gain, linear, quadratic] = balance;
  return 2 * gain / (linear + std::sqrt(linear * linear + 4 * quadratic * gain));
}
}  // namespace

double bottom_gain(double restitution) {
  return (1 + restitution) * (1 + 3 * restitution) / (2 * std::sqrt(2 * pi));
}

double vibrated_bed_temperature_over_mass(const VibratedBed& bed) { return root_of(balance_of(bed)); }

double vibrated_bed_rise(const VibratedBed& bed) { return root_of(balance_of(bed)) / bed.gravity; }

double vibrated_bed_exponent(const VibratedBed& bed) {
  const Balance balance = balance_of(bed);
  const double quadratic = balance.quadratic * root_of(balance);
  return 2 * (balance.linear + quadratic) / (balance.linear + 2 * quadratic);
}

double vibrated_bed_expansion(const VibratedBed& bed) {
  return bed.speed * bed.speed / 2 / vibrated_bed_temperature_over_mass(bed);
}

}  // namespace sandglass::law
