#pragma once

namespace sandglass::law {

// Impact parameters b, in units of the diameter, with the density a/(1 - c b^2) on the line [-1, 1] (disks) or, by
// area, on the unit disk (spheres). c = 0 is molecular chaos, c > 0 has more grazing collisions; c < 1. Mueller 2001
// (3.18) for disks.

/// a: sqrt(c)/(2 artanh sqrt(c)) on the line, -c/(pi ln(1 - c)) on the disk.
double impact_normalisation(int dimension, double coefficient);

/// Mean of the normal share 1 - b^2 of the energy of relative motion, over that of c = 0 (2/3 on the line, 1/2 on the
/// disk): what a collision dissipates on average, when the speed does not depend on b.
double impact_dissipation_ratio(int dimension, double coefficient);

/// Share of the collisions with a parameter below b: b from -1 to 1 on the line, the distance from 0 to 1 on the disk.
double impact_cumulative(int dimension, double coefficient, double b);

/// The b at which impact_cumulative is `share`: draws from the distribution when the share is drawn evenly.
double impact_quantile(int dimension, double coefficient, double share);

}  // namespace sandglass::law
