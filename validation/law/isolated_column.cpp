#include "validation/law/isolated_column.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::law {

namespace {
double per_height(const Column& column) { return column.mass * column.gravity / column.temperature; }
double square(double value) { return value * value; }
}  // namespace

/// Of w between 0 and x = m g h/T, whose density is e^-w: <w> = 1 - x/(e^x - 1), var w = 1 - (x/2)^2/sinh^2(x/2).
IsolatedColumn::IsolatedColumn(const Column& column, int dimension, double particles)
    : per_height_(per_height(column)), height_(column.height) {
  const double lid = per_height_ * height_;
  mean_ = 1 - lid / std::expm1(lid);
  variance_ = 1 - square(lid / 2 / std::sinh(lid / 2));
  capacity_ = particles * (dimension / 2.0 + variance_);
}

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

/// The density over its mean is x e^-w/(1 - e^-x), and (x/2) coth(x/2) where the mean particle is.
double excluded_volume_shift(const Column& column, double excluded, double z) {
  const double lid = per_height(column) * column.height;
  const double here = lid * std::exp(-per_height(column) * z) / -std::expm1(-lid);
  return -2 * excluded * (here - lid / 2 / std::tanh(lid / 2));
}

}  // namespace sandglass::law
