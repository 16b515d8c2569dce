#include "validation/law/few_body_line.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace sandglass::law {

namespace {
constexpr double kInfinite = std::numeric_limits<double>::infinity();
}

double row_coupling(const std::array<double, 3>& masses) {
  return masses[0] * masses[2] / ((masses[0] + masses[1]) * (masses[1] + masses[2]));
}

double collapse_restitution(const std::array<double, 3>& masses) {
  const double coupling = row_coupling(masses);
  const double plus = 1 + std::sqrt(1 - coupling);
  return coupling / (plus * plus);  // (1 - s)/(1 + s) without the cancellation
}

double most_collisions(const std::array<double, 3>& masses, double restitution) {
  if (restitution <= collapse_restitution(masses)) return kInfinite;
  const double cosine = (1 + restitution) / 2 * std::sqrt(row_coupling(masses) / restitution);
  const double turns = std::numbers::pi / std::acos(cosine);
  return std::ceil(turns - 1e-9);  // equal elastic balls: three, not four by rounding
}

namespace {
/// From the ratio of each approach speed to the one before, which cannot run out of digits.
double count_in_a_row(const std::array<double, 3>& masses, double restitution,
                      const std::array<double, 3>& velocities) {
  constexpr int most = 100000;
  const double approach = velocities[0] - velocities[1];
  if (!(approach > 0)) return 0;
  const double share[2] = {(1 + restitution) * masses[0] / (masses[0] + masses[1]),
                           (1 + restitution) * masses[2] / (masses[1] + masses[2])};
  double ratio = share[0] + (velocities[1] - velocities[2]) / approach;
  for (int n = 1; n < most; ++n) {
    if (!(ratio > 0)) return n;
    ratio = share[n % 2] - restitution / ratio;
  }
  return kInfinite;
}
}  // namespace

RowResult three_in_a_row(const std::array<double, 3>& masses, double restitution,
                         std::array<double, 3> velocities) {
  const double collisions = count_in_a_row(masses, restitution, velocities);
  if (std::isinf(collisions)) {
    const double mean = (masses[0] * velocities[0] + masses[1] * velocities[1] + masses[2] * velocities[2]) /
                        (masses[0] + masses[1] + masses[2]);
    return {{mean, mean, mean}, collisions};
  }
  for (int n = 0; n < collisions; ++n) {
    const auto left = static_cast<std::size_t>(n % 2), right = left + 1;
    const double impulse = (1 + restitution) * (velocities[left] - velocities[right]) * masses[left] *
                           masses[right] / (masses[left] + masses[right]);
    velocities[left] -= impulse / masses[left];
    velocities[right] += impulse / masses[right];
  }
  return {velocities, collisions};
}

double cradle_speed(int balls_passed, double restitution, double speed) {
  return speed * std::pow((1 + restitution) / 2, balls_passed);
}

}  // namespace sandglass::law
