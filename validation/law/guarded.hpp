#pragma once

#include "validation/law/gas.hpp"
#include "validation/law/virial.hpp"

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

/// The same of spheres as Luding & Goldshtein (2003) give it: exp(-1.268 y + 0.01682 y^2 - 0.0005783 y^3), y = sqrt(pi) x.
/// From their mean-field theory, to third order in x.
double guarded_share_polynomial(double x);

/// What positions change. A particle that has just left another finds it in the way of those that come from there: fewer
/// short gaps, and a larger share by exp(0.125 x - 0.026 x^2). Fitted, to 0.3% up to x = 1.2, to elastic disks at an area
/// fraction of 0.65 in a program apart from this one (docs/theory.md); at 0.45 and 0.25 the same to 1%. Of other gases half of
/// it is expected and half allowed.
Bounded guarded_share_of_contacts(const Gas& gas, double x);

/// -(dT/dt)/T = (1-r^2) omega/D guarded_share(omega t_c) [1/time].
double guarded_cooling_rate(const Gas& gas, double contact_time);

}  // namespace sandglass::law
