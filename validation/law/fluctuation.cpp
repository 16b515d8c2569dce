#include "validation/law/fluctuation.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/state.hpp"

#include <cmath>
#include <numbers>

namespace sandglass::law {

double count_variance(const Gas& gas, double mean, double share) {
  return mean * long_wave_structure(gas) * (1 - share);
}

namespace {
double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

/// Mean of a wave over `count` points a phase of 2x apart about their middle.
double mean_over(double count, double x) {
  const double below = count * std::sin(x);
  return std::abs(below) < 1e-9 ? 1 : std::sin(count * x) / below;
}
}  // namespace

double cell_structure(const Gas& gas, double wave_number, const CellFluid& cells) {
  const double x = wave_number * cells.edge / 2;
  const double pairs = 2 * excluded_fraction(gas) * contact_value(gas.dimension, gas.fraction);
  const double slope =
      excluded_fraction(gas) * gas.fraction * contact_value_slope(gas.dimension, gas.fraction);
  return 1 / (1 + sinc(x) * sinc(x) * (pairs + slope * mean_over(cells.window, x)));
}

double cell_count_variance(const Gas& gas, double mean, double share, double length, const CellFluid& cells) {
  const double lowest = 2 * std::numbers::pi / length;
  double sum = 0, rest = 1 - share;  // the weights of all waves add up to 1 - share
  for (double mode = 1; mode * share <= 1000; ++mode) {
    const double weight = 2 * share * std::pow(sinc(mode * std::numbers::pi * share), 2);
    sum += weight * cell_structure(gas, mode * lowest, cells);
    rest -= weight;
  }
  return mean * (sum + rest * cell_structure(gas, 1000 * lowest / share, cells));
}

double white_spectrum_level(double variance, double samples) { return 2 * variance / samples; }

}  // namespace sandglass::law
