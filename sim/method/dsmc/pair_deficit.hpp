#pragma once

#include "sim/method/dsmc/parameters.hpp"

namespace sandglass::dsmc {

/// The part of the collisions that a uniform gas with offsets loses to cells of few particles, the shortfall of its
/// collisional pressure nearly the same. `number_density` is that of real particles; a cell has the volume that
/// `particles_per_cell` simulated ones take up.
///
/// Two parts. Offsets push particles apart as the pressure that they carry does: long waves of the density are down to
/// S = 1/(1 + chi), chi the derivative of that pressure to density over temperature, and a cell of N_c particles and edge
/// L holds a part c (1 - S)/N_c fewer pairs than by chance, less in cells not much wider than an offset. The rest comes
/// from the window of the contact factor, which takes its scatter for that of chance.
/// c and the dependence on L are fitted to runs of the elastic gas (fractions 0.05 to 0.3, 3 to 20 particles a cell of
/// 0.7 to 5.6 diameters, offsets of 0.5 to 1.5): within 15% of what is missing, or 0.3% of the rate, and above it where
/// particles cross a cell in one step. With expected pairs only the scatter of the window is left.
///
/// Partners at contact push each other apart in the same way, and miss pairs by the same two parts. There the first follows
/// from the pair correlation of linear theory (docs/theory.md), within 12% of its integral.
double expected_pair_deficit(int dimension, const Parameters& parameters, double number_density,
                             double particles_per_cell);

/// Particles per cell for which that part is below one percent even where it is a fifth larger than expected, and at
/// least ten. Edge of such cells:
/// (particles * weight / number density)^(1/D).
double default_particles_per_cell(int dimension, const Parameters& parameters, double number_density);

}  // namespace sandglass::dsmc
