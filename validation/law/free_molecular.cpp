#include "validation/law/free_molecular.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_bessel.h>

namespace sandglass::law {

namespace {
using std::numbers::pi;
const double kRootPi = std::sqrt(pi);

// Forces are in units of rho R^(D-1) U sqrt(2T/m); s = U/sqrt(2T/m), not negative. Finite at s = 0.

/// Momentum that arrives at a disk: (C_D s) of a cylinder that keeps all of it.
double arriving_at_disk(double s) {
  const double half = s * s / 2;
  return kRootPi *
         ((s * s + 1.5) * gsl_sf_bessel_I0_scaled(half) + (s * s + 0.5) * gsl_sf_bessel_I1_scaled(half));
}

/// The same at a sphere. Below s = 0.05, where its terms cancel, the first terms of its series.
double arriving_at_sphere(double s) {
  const double square = s * s;
  if (s < 0.05) return pi / 2 * 16 / (3 * kRootPi) * (1 + square / 5 - square * square / 70);
  const double flat = (2 * square + 1) * std::exp(-square) / (kRootPi * square);
  const double round = (4 * square * square + 4 * square - 1) * std::erf(s) / (2 * square * s);
  return pi / 2 * (flat + round);
}

/// What a mirror takes, over what arrives: a sphere scatters alike in all directions, a disk does not.
double mirror_factor(int dimension) { return dimension == 2 ? 4.0 / 3 : 1; }

/// Push of the particles that leave at the temperature of the gas.
double leaving(int dimension) { return dimension == 2 ? pi * kRootPi / 4 : pi * kRootPi / 3; }
}  // namespace

double knudsen_temperature(double first_wall, double second_wall) {
  return std::sqrt(first_wall) * std::sqrt(second_wall);
}

double free_molecular_drag(const StreamPastObstacle& stream) {
  const double speed = std::sqrt(2 * stream.temperature / stream.mass);
  const double s = std::abs(stream.velocity) / speed;
  const double arriving = stream.dimension == 2 ? arriving_at_disk(s) : arriving_at_sphere(s);
  const double thermal =
      arriving + leaving(stream.dimension) * std::sqrt(stream.surface_temperature / stream.temperature);
  const double mirrored = mirror_factor(stream.dimension) * arriving;
  const double force = stream.accommodation * thermal + stream.reversal * 2 * arriving +
                       (1 - stream.accommodation - stream.reversal) * mirrored;
  const double unit = stream.mass * stream.number_density * std::pow(stream.radius, stream.dimension - 1) *
                      stream.velocity * speed;
  return unit * force;
}

double barometric_fraction(const Column& column, double z) {
  const double inside = std::clamp(z, 0.0, column.height);
  const double rate = column.mass * column.gravity / column.temperature;
  if (rate == 0) return inside / column.height;
  return std::expm1(-rate * inside) / std::expm1(-rate * column.height);
}

}  // namespace sandglass::law
