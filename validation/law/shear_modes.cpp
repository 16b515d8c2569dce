#include "validation/law/shear_modes.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/transport.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sandglass::law {

namespace {
/// Sum over the wave vectors of the axes from `axis` on, of square wave number `square` along those before.
double sum_of_waves(std::span<const double> box, std::size_t axis, double square, double marginal,
                    double shortest) {
  if (axis == box.size()) {
    if (square == 0) return 0;
    return square > marginal ? marginal / (square - marginal) : HUGE_VAL;
  }
  const double base = 2 * std::numbers::pi / box[axis];
  double sum = 0;
  for (int n = 0; square + std::pow(n * base, 2) <= shortest; ++n)
    sum += (n == 0 ? 1 : 2) * sum_of_waves(box, axis + 1, square + std::pow(n * base, 2), marginal, shortest);
  return sum;
}
}  // namespace

double marginal_wave_number(const Gas& gas) {
  return std::sqrt(cooling_rate(gas) / (2 * enskog_kinematic_viscosity(gas, SonineOrder::converged)));
}

double marginal_wave_length(const Gas& gas) { return 2 * std::numbers::pi / marginal_wave_number(gas); }

double shear_mode_share(const Gas& gas, std::span<const double> box, double particles) {
  const double marginal = std::pow(marginal_wave_number(gas), 2);
  const double longest_scale = std::max(mean_free_path(gas), gas.diameter);
  const double sum = sum_of_waves(box, 0, 0, marginal, 1 / (longest_scale * longest_scale));
  return (gas.dimension - 1) * sum / (gas.dimension * (particles - 1));
}

}  // namespace sandglass::law
