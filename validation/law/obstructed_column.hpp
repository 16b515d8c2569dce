#pragma once

#include "validation/law/free_molecular.hpp"

#include <vector>

namespace sandglass::law {

/// A disk (dimension 2) or sphere (3) that no particle enters, in one piece inside the column.
struct RoundObstacle {
  double height = 0;  ///< of its centre
  double radius = 0;
};

/// A column at rest round obstacles. `area` is that of floor and lid, in 2D their length.
struct ObstructedColumn {
  Column column;
  int dimension = 2;
  double area = 1;
  std::vector<RoundObstacle> obstacles;
};

/// Share of the particles below z: the integral of exp(-m g z/T) over the free part below, over that of the whole free part.
/// Isothermal ideal gas, whatever the surfaces do as long as they keep its temperature. Boltzmann 1868.
double obstructed_fraction(const ObstructedColumn& column, double z);

/// Force of one particle on the floor and on the lid, mean over time [mass length/time^2]: the pressure n T there times the
/// area. Their difference is the weight of the particle and that of those whom obstacles displace (Archimedes).
double floor_force(const ObstructedColumn& column);
double lid_force(const ObstructedColumn& column);

}  // namespace sandglass::law
