#include "validation/law/pair_deficit.hpp"

#include "validation/law/contact.hpp"
#include "validation/law/state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gsl/gsl_sf_bessel.h>

namespace sandglass::law {

namespace {
constexpr int kWaves2 = 150, kWaves3 = 40;  // along an axis, by the rule of midpoints
constexpr double kShortest =
    6 * std::numbers::pi;       // of k edge/2: shorter waves have a hundredth of the weight
constexpr double kStep = 1e-3;  // of nu, for the second derivative of g

/// Parts of Poisson's covariances that are missing: of two counts of a cell, of a cell with its window, of the window.
struct Missing {
  double cell = 0, mixed = 0, window = 0;
};

/// Derivatives of the rate nu^2 g to the density: 2 nu g'/g and nu^2 g''/(2g).
struct Growth {
  double slope, curvature;
};

Growth growth(const Gas& gas) {
  const double nu = gas.fraction, step = kStep * nu, g = contact_value(gas.dimension, nu);
  const double second =
      (contact_value_slope(gas.dimension, nu + step) - contact_value_slope(gas.dimension, nu - step)) /
      (2 * step);
  return {2 * nu * contact_value_slope(gas.dimension, nu) / g, nu * nu * second / (2 * g)};
}

double deficit(const Missing& missing, const Growth& growth, const PairCells& cells, int dimension) {
  const double in_window = cells.particles * std::pow(cells.window, dimension);
  return missing.cell / cells.particles +
         (growth.slope * missing.mixed + growth.curvature * missing.window) / in_window;
}

/// All waves damped as the longest; a closed box has none with k = 0.
Missing of_long_waves(const Gas& gas, const PairCells& cells) {
  const double all = 1 - long_wave_structure(gas);
  const double cell = all * (1 - 1 / cells.cells);
  const double window = all * std::max(0.0, 1 - std::pow(cells.window, gas.dimension) / cells.cells);
  return {cell, window, window};
}

/// Mean over directions of what a momentum that is carried over `x` wave lengths/(2 pi) gives a wave, over that of short ways.
double carried(int dimension, double x) {
  if (x < 1e-3) return 1;
  if (dimension == 2) return 2 * gsl_sf_bessel_J1(x) / x;
  return 3 * (std::sin(x) - x * std::cos(x)) / (x * x * x);
}

/// A wave along one axis: its number k, what cell and window see of it, and its weight in the variance of a cell's count.
struct Wave {
  double k, cell, window, weight;
};

std::vector<Wave> waves_along(const PairCells& cells, int count) {
  std::vector<Wave> waves;
  const double step = kShortest / count,
               all = std::numbers::pi / 2;  // integral of sin^2(x)/x^2 over all waves
  for (int i = 0; i < count; ++i) {
    const double x = (i + 0.5) * step, sine = std::sin(x), seen = sine * sine / (x * x);
    waves.push_back(
        {2 * x / cells.edge, seen, std::sin(cells.window * x) / (cells.window * sine), seen * step / all});
  }
  return waves;
}

Wave together(const Wave& a, const Wave& b) {
  return {std::hypot(a.k, b.k), a.cell * b.cell, a.window * b.window, a.weight * b.weight};
}

/// The linear fluid of cells, as cell_structure(), in all dimensions.
Missing of_cell_fluid(const Gas& gas, const PairCells& cells) {
  const int dimension = gas.dimension;
  const double pairs = 2 * excluded_fraction(gas) * contact_value(dimension, gas.fraction);
  const double slope = excluded_fraction(gas) * gas.fraction * contact_value_slope(dimension, gas.fraction);
  const std::vector<Wave> waves = waves_along(cells, dimension == 2 ? kWaves2 : kWaves3);
  const double whole = std::pow(cells.window, dimension);
  Missing missing;
  const auto add = [&](const Wave& wave) {
    const double stiff =
        carried(dimension, wave.k * gas.diameter) * wave.cell * (pairs + slope * wave.window);
    const double part = wave.weight * (1 - 1 / (1 + stiff));
    missing.cell += part;
    missing.mixed += part * wave.window * whole;
    missing.window += part * wave.window * wave.window * whole;
  };
  for (const Wave& a : waves)
    for (const Wave& b : waves) {
      const Wave plane = together(a, b);
      if (dimension == 2)
        add(plane);
      else
        for (const Wave& c : waves) add(together(plane, c));
    }
  const double uniform = (1 - long_wave_structure(gas)) / cells.cells;
  return {missing.cell - uniform, missing.mixed - uniform * whole, missing.window - uniform * whole};
}
}  // namespace

Bounded pair_deficit(const Gas& gas, const PairCells& cells) {
  const Growth local = growth(gas);
  const double most = deficit(of_long_waves(gas, cells), local, cells, gas.dimension);
  const double least = deficit(of_cell_fluid(gas, cells), local, cells, gas.dimension);
  return {(most + least) / 2, 0, std::abs(most - least) / 2};
}

}  // namespace sandglass::law
