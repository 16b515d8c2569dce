#pragma once

#include "validation/law/gas.hpp"

namespace sandglass::law {

/// Sonine order of the dilute viscosity: the first, or the limit (1.022 times it for disks, Gass 1971;
/// 1.016 times it for spheres, Chapman & Cowling 1970 sec. 10.21).
enum class SonineOrder { first, converged };

/// Dilute elastic gas, sqrt(mT/pi)/(2d) for disks and 5 sqrt(mT/pi)/(16 d^2) for spheres
/// [mass length^(2-D) time^-1].
double boltzmann_shear_viscosity(const Gas& gas, SonineOrder order);

/// Heat conductivity of the dilute elastic gas, (D+2)/2 D/(D-1) eta0/m with eta0 to first order: 2 sqrt(T/(pi m))/d for
/// disks, 75 sqrt(T/(pi m))/(64 d^2) for spheres [length^(2-D) time^-1]; times 1.0297 (disks; docs/theory.md, Gass 1971
/// has 1.029) or 1.0252 (spheres; Pekeris & Alterman 1957) for all orders. Temperature is an energy.
double boltzmann_conductivity(const Gas& gas, SonineOrder order);

/// Elastic Enskog gas, (eta0/g) (1 + 2bng/(D+2))^2 + D/(D+2) kappa, with bn = 2^(D-1) nu.
/// Gass (1971) for disks, Chapman & Cowling (1970) sec. 16.5 for spheres.
double enskog_shear_viscosity(const Gas& gas, SonineOrder order);

/// Bulk viscosity kappa of the elastic Enskog gas: 16/pi nu^2 g eta0 for disks, 256/(5 pi) nu^2 g eta0 for
/// spheres, eta0 to first order: it needs no Sonine expansion.
double enskog_bulk_viscosity(const Gas& gas);

/// Enskog shear viscosity over mass density [length^2/time]; a shear wave of wave number k decays at k^2 nu.
double enskog_kinematic_viscosity(const Gas& gas, SonineOrder order);

/// How a Monte Carlo scheme departs from Boltzmann's equation. Lengths in diameters.
struct CellScheme {
  double contact = 1;              ///< collision rate over that of the dilute gas
  double along = 0;                ///< displacement of the partners along their momentum change (cba: 1)
  double random = 0;               ///< and in a random direction (cuba)
  double cell_edge = 0;            ///< of the cells in which pairs are drawn, across the flow
  double collisions_per_step = 0;  ///< of a particle
};

/// Shear viscosity of an elastic gas whose partners collide as if in one place and are displaced then
/// (docs/theory.md#viscosity-of-monte-carlo-schemes); terms of cell and step as in Alexander, Garcia & Alder 1998 and
/// Hadjiconstantinou 2000 [mass length^(2-D) time^-1].
double monte_carlo_shear_viscosity(const Gas& gas, const CellScheme& scheme, SonineOrder order);

/// The same over mass density [length^2/time].
double monte_carlo_kinematic_viscosity(const Gas& gas, const CellScheme& scheme, SonineOrder order);

}  // namespace sandglass::law
