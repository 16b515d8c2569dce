#pragma once

#include "validation/law/sedimentation.hpp"

// What few particles and their size change of the barometric law, to first order: shares of the law's own value.

namespace sandglass::law {

/// N particles that collide and share one energy. One of them at z has taken m g (z - <z>) from all others, whose heat
/// capacity is N C, C = D/2 + var(m g z/T): they are colder by that, T(z)/T - 1 = -(w - <w>)/(N C) with w = m g z/T.
/// Terms in 1/N^2 are left out. Derivation: docs/theory.md.
class IsolatedColumn {
 public:
  IsolatedColumn(const Column& column, int dimension, double particles);
  /// One species among others: `capacity` is that of all particles, N C with C = freedom/2 + mean of var w.
  IsolatedColumn(const Column& column, double capacity);
  double temperature_shift(double z) const;
  /// From d(n T)/dz = -m g n with that temperature.
  double density_shift(double z) const;
  /// Of the density, at the height where it is largest: w = <w> + 1, or the lid.
  double largest_density_height() const;

 private:
  double away(double z) const;  ///< w - <w>

  double per_height_, height_, mean_, variance_, capacity_;
};

/// Mean particles in a bin, and by how much the shift of the mean temperature there grows when each sample counts with its
/// particles less one: cov(n - 1, n)/<n - 1> of a Poisson number, empty samples aside.
double weight_of_crowded_samples(double mean_particles);

/// Heat capacity N C of a mixture.
double heat_capacity(const MixedColumn& column, double temperature, double particles);

/// Particles with a second virial coefficient B: ln n + 2 B n = -m g z/T + const. `excluded` is B times the mean density.
double excluded_volume_shift(const Column& column, double excluded, double z);

}  // namespace sandglass::law
