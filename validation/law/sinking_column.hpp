#pragma once

#include "validation/law/gas.hpp"

#include <vector>

namespace sandglass::law {

/// A column of dilute gas between floor and lid, evenly spread at the temperature of the gas when gravity begins to act.
struct SinkingColumn {
  Gas gas;
  double gravity = 1;
  double height = 1;
  double freedom = 3;  ///< quadratic degrees of freedom of a particle
};

/// Height of the centre of mass at equal steps of time from zero on.
struct Fall {
  double step = 0;
  std::vector<double> height;
};

/// The equations of Navier, Stokes and Fourier in one dimension, in the coordinates of the particles (Lagrange): n, u and T
/// of `cells` parts of equal number; viscosity and conductivity of the smooth dilute gas, all Sonine orders; no heat through
/// the ends, which are mirrors. Second order in the cells, fourth in time. Holds to second order in the mean free path over
/// the height; spins are taken to follow the translation at once.
Fall fall_of_column(const SinkingColumn& column, double until, int cells = 50);

/// Its first lowest point: when, and how far below the place at rest over the fall to there.
struct Bounce {
  double time = 0, depth = 0;
};
Bounce first_bounce(const SinkingColumn& column);

}  // namespace sandglass::law
