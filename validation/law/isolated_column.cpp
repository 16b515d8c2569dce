#include "validation/law/isolated_column.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::law {

namespace {
double per_height(const Column& column) { return column.mass * column.gravity / column.temperature; }
double square(double value) { return value * value; }
}  // namespace

IsolatedColumn::IsolatedColumn(const Column& column, double capacity)
    : per_height_(per_height(column)),
      height_(column.height),
      mean_(per_height_ * mean_column_height(column)),
      variance_(column_height_variance(column)),
      capacity_(capacity) {}

IsolatedColumn::IsolatedColumn(const Column& column, int dimension, double particles)
    : IsolatedColumn(column, particles * (dimension / 2.0 + column_height_variance(column))) {}

double IsolatedColumn::away(double z) const { return per_height_ * z - mean_; }

double IsolatedColumn::temperature_shift(double z) const { return -away(z) / capacity_; }

/// d ln n/dw = -T/T(z) - d ln T(z)/dw = -1 + (1 - away)/(N C); the constant keeps the number of particles.
double IsolatedColumn::density_shift(double z) const {
  return (away(z) - square(away(z)) / 2 + variance_ / 2) / capacity_;
}

double IsolatedColumn::largest_density_height() const { return std::min((mean_ + 1) / per_height_, height_); }

double weight_of_crowded_samples(double mean_particles) {
  return mean_particles * -std::expm1(-mean_particles) / (mean_particles + std::expm1(-mean_particles));
}

double heat_capacity(const MixedColumn& column, double temperature, double particles) {
  double each = column.freedom / 2;
  for (const ColumnSpecies& species : column.species)
    each +=
        species.share * column_height_variance({species.mass, temperature, column.gravity, species.height});
  return particles * each;
}

/// The density over its mean is (x/2) coth(x/2) where the mean particle is.
double excluded_volume_shift(const Column& column, double excluded, double z) {
  const double lid = per_height(column) * column.height;
  return -2 * excluded * (column_density(column, z) - lid / 2 / std::tanh(lid / 2));
}

}  // namespace sandglass::law
