#include "sim/method/dsmc/pair_deficit.hpp"

#include "sim/method/dsmc/expected_pairs.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>

namespace sandglass::dsmc {

namespace {
constexpr double kLargestDeficit = 0.008, kFewest = 10, kMost = 1000;

struct Gas {
  int dimension;
  const Parameters& parameters;

  double contact(double fraction) const {
    return parameters.factor.formula == nullptr ? 1 : parameters.factor.formula(fraction).value;
  }
  /// Collisional pressure over that of free flight; r = 1 and an offset of one diameter give that of hard cores.
  double collisional(double fraction) const {
    const double length = parameters.partners == Partners::contact
                              ? (1 + parameters.restitution) / 2
                              : parameters.offset.consistent / parameters.diameter * parameters.restitution;
    return std::exp2(dimension - 1) * fraction * contact(fraction) * length;
  }
  /// d(fraction f)/d fraction.
  template <class Function>
  static double slope(double fraction, Function f) {
    const double step = 1e-4 * fraction, high = fraction + step, low = fraction - step;
    return (high * f(high) - low * f(low)) / (2 * step);
  }
};

/// Particles in the window of the contact factor, see window_cells().
double in_window(int dimension, double per_cell, const Parameters& parameters) {
  double edge = std::max(parameters.factor.window, 1U);
  if (parameters.factor.window == 0)
    while (std::pow(edge, dimension) * per_cell < window_particles(parameters)) edge += 2;
  return std::pow(edge, dimension) * per_cell;
}

/// Part of the pairs that is missing from a cell, for a gas whose long waves are down by `missing`.
double of_cell(double missing, double offset, double path, double edge, double per_cell) {
  return 0.745 * missing / (1 + 0.87 * offset / edge + 0.34 * path * offset / (edge * edge)) / per_cell;
}
/// The same for partners at contact, of a gas whose collisional pressure rises by `slope` with density.
double of_surroundings(int dimension, double slope, double edge, double per_cell) {
  const double near = std::pow(2.0 / 3, dimension) * slope;
  return near / (1 + 1.6 * near) / (1 + 1.45 * dimension * std::pow(edge, -2.5)) / per_cell;
}
}  // namespace

double expected_pair_deficit(int dimension, const Parameters& parameters, double number_density,
                             double particles_per_cell) {
  const double offset = parameters.offset.length();
  const bool contact_partners = parameters.partners == Partners::contact;
  if ((parameters.offset.consistent == 0 && !contact_partners) || number_density <= 0) return 0;
  const Gas gas{dimension, parameters};
  const double fraction = number_density * particle_volume(dimension, parameters.diameter);
  const double contact = gas.contact(fraction);
  const double slope = gas.slope(fraction, [&](double nu) { return gas.collisional(nu); });
  const double missing = slope / (1 + slope);
  const double growth = gas.slope(fraction, [&](double nu) { return gas.contact(nu); }) / contact - 1;
  const double window = in_window(dimension, particles_per_cell, parameters);
  if (parameters.pair_count == PairCount::expected) return missing * (1 + 2 * growth) / window;
  const double scatter = 2 * missing * growth / window;
  const double edge = std::pow(particles_per_cell * parameters.weight / number_density, 1.0 / dimension);
  if (contact_partners)
    return of_surroundings(dimension, slope, edge / parameters.diameter, particles_per_cell) + scatter;
  const double path =
      1 / (M_SQRT2 * number_density * cross_section(dimension, parameters.diameter) * contact);
  return weight_of_missing_pairs(path / offset) * of_cell(missing, offset, path, edge, particles_per_cell) +
         scatter;
}

double default_particles_per_cell(int dimension, const Parameters& parameters, double number_density) {
  double particles = kFewest;
  while (particles < kMost &&
         expected_pair_deficit(dimension, parameters, number_density, particles) > kLargestDeficit)
    ++particles;
  return particles;
}

}  // namespace sandglass::dsmc
