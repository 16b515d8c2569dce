#pragma once

#include "validation/law/gas.hpp"

// Cooling under the TC model (Luding & McNamara 1998): a collision is elastic when the previous one of a partner was
// less than t_c ago. x = omega t_c throughout.

namespace sandglass::law {

/// Collisions per time of a particle of speed s sqrt(2T/m) in a Maxwellian gas, over omega. Chapman & Cowling (1970)
/// sec. 5.4 for spheres; Rice's mean distance for disks.
double speed_resolved_rate(int dimension, double s);

/// Share of the energy loss that the guard leaves, <g^3 exp(-(omega_1 + omega_2) t_c)> / <g^3>: the gaps of both
/// partners are independent, with the rate of their own speed. Follows from reversibility of the elastic Enskog gas;
/// inelastic correlations, recollisions and the cooling within t_c are left out.
double guarded_share(int dimension, double x);

/// The same if every particle had the mean rate, exp(-2x): leading term of Luding & Goldshtein (2003).
double guarded_share_of_mean_rate(double x);

/// -(dT/dt)/T = (1-r^2) omega/D guarded_share(omega t_c) [1/time].
double guarded_cooling_rate(const Gas& gas, double contact_time);

}  // namespace sandglass::law
