#pragma once

#include "validation/law/free_molecular.hpp"

#include <vector>

// A closed column of gas that starts evenly spread and sinks under gravity: what it ends in (Kawasaki 1986, Appendix B),
// and the first swing on the way there. Any number of species, in two or three dimensions, with or without spin.

namespace sandglass::law {

/// One species of a mixture.
struct ColumnSpecies {
  double mass = 1;
  double share = 1;   ///< of all particles
  double height = 1;  ///< that its centres have between floor and lid
};

struct MixedColumn {
  std::vector<ColumnSpecies> species;  ///< shares add up to one
  double gravity = 1;                  ///< above zero
  double freedom =
      3;  ///< quadratic degrees of freedom of a particle: D smooth, 3 rough disks, 6 rough spheres
};

/// Mean height of the particles of a column at one temperature, T/(m g) - h/(exp(m g h/T) - 1).
double mean_column_height(const Column& column);
/// Variance of m g z/T: 1 - (x/2)^2/sinh^2(x/2), x = m g h/T.
double column_height_variance(const Column& column);
/// Number density at z over its mean, x exp(-m g z/T)/(1 - exp(-x)). (B.5)
double column_density(const Column& column, double z);

/// Kinetic, rotational and potential energy of a particle in equilibrium; heights count from the lowest place of each
/// species.
double column_energy(const MixedColumn& column, double temperature);
/// Of a start at temperature T0, evenly spread: freedom T0/2 + sum of share m g h/2.
double even_column_energy(const MixedColumn& column, double temperature);

/// Temperature of equilibrium at an energy per particle above zero: the root of `column_energy`. (B.7), which is damaged
/// in our copy: docs/errata.md. Exact for an ideal gas of infinitely many particles.
double sedimentation_temperature(const MixedColumn& column, double energy);

/// Angular frequency of the slowest sound wave that stands in an isothermal column between floor and lid, without
/// viscosity and conduction: w^2 = (c/T) (T/m) (pi^2/h^2 + (m g/2T)^2), c/T = 1 + 2/freedom. Lamb 1932, art. 309.
double column_sound_frequency(const Column& column, double freedom);

}  // namespace sandglass::law
