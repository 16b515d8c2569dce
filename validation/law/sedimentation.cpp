#include "validation/law/sedimentation.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

namespace sandglass::law {

namespace {
double square(double value) { return value * value; }

/// m g h/T: how much less dense the lid is than the floor, as a logarithm.
double thickness(const Column& column) {
  return column.mass * column.gravity * column.height / column.temperature;
}

Column part(const MixedColumn& all, const ColumnSpecies& species, double temperature) {
  return {species.mass, temperature, all.gravity, species.height};
}

struct Search {
  const MixedColumn& column;
  double energy;
};

double excess(double temperature, void* search) {
  const auto* asked = static_cast<const Search*>(search);
  return column_energy(asked->column, temperature) - asked->energy;
}
}  // namespace

/// x/(e^x - 1) and its like, where x = 0 is a limit.
double mean_column_height(const Column& column) {
  const double x = thickness(column);
  if (x < 1e-3) return column.height * (0.5 - x / 12);
  return column.height * (1 / x - 1 / std::expm1(x));
}

double column_height_variance(const Column& column) {
  const double half = thickness(column) / 2;
  if (half < 1e-3) return half * half / 3;
  return 1 - square(half / std::sinh(half));
}

double column_density(const Column& column, double z) {
  const double x = thickness(column);
  if (x == 0) return 1;
  return x * std::exp(-x * z / column.height) / -std::expm1(-x);
}

double column_energy(const MixedColumn& column, double temperature) {
  double energy = column.freedom * temperature / 2;
  for (const ColumnSpecies& species : column.species)
    energy += species.share * species.mass * column.gravity *
              mean_column_height(part(column, species, temperature));
  return energy;
}

double even_column_energy(const MixedColumn& column, double temperature) {
  double energy = column.freedom * temperature / 2;
  for (const ColumnSpecies& species : column.species)
    energy += species.share * species.mass * column.gravity * species.height / 2;
  return energy;
}

/// A particle's potential energy lies between 0 and T, and the energy grows with T: one root between these ends.
double sedimentation_temperature(const MixedColumn& column, double energy) {
  gsl_set_error_handler_off();
  Search search{column, energy};
  gsl_function function{excess, &search};
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), &function, energy / (1 + column.freedom / 2) * (1 - 1e-12),
                       2 * energy / column.freedom * (1 + 1e-12));
  for (int step = 0; step < 200; ++step) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) return std::nan("");
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()),
                               0, 1e-14) == GSL_SUCCESS)
      break;
  }
  return gsl_root_fsolver_root(solver.get());
}

double column_sound_frequency(const Column& column, double freedom) {
  const double wave = std::numbers::pi / column.height;
  const double fall = column.mass * column.gravity / (2 * column.temperature);
  return std::sqrt((1 + 2 / freedom) * column.temperature / column.mass * (wave * wave + fall * fall));
}

}  // namespace sandglass::law
