#pragma once

#include <cmath>
#include <numbers>

namespace sandglass::law {

/// A uniform gas of equal smooth hard particles: disks (dimension 2) or spheres (dimension 3).
struct Gas {
  int dimension = 2;
  double diameter = 1;
  double mass = 1;
  double temperature = 1;  ///< granular temperature m<C^2>/dimension, an energy
  double fraction = 0;     ///< area fraction in 2D, volume fraction in 3D
  double restitution = 1;  ///< normal restitution, 0..1
};

/// Area (2D) or volume (3D) of one particle.
inline double particle_volume(const Gas& gas) {
  const double square = std::numbers::pi * gas.diameter * gas.diameter;
  return gas.dimension == 2 ? square / 4 : square * gas.diameter / 6;
}

/// Particles per area or volume.
inline double number_density(const Gas& gas) { return gas.fraction / particle_volume(gas); }

/// Standard deviation of one velocity component, sqrt(T/m).
inline double thermal_speed(const Gas& gas) { return std::sqrt(gas.temperature / gas.mass); }

/// Second virial coefficient times number density: 2 nu for disks, 4 nu for spheres.
inline double excluded_fraction(const Gas& gas) { return (gas.dimension == 2 ? 2 : 4) * gas.fraction; }

}  // namespace sandglass::law
