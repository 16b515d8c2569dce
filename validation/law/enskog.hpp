#pragma once

#include "validation/law/gas.hpp"

namespace sandglass::law {

/// Collisions per particle and time in the Enskog theory for a Maxwellian [1/time]:
/// 2 sqrt(pi) n d g sqrt(T/m) in 2D, 4 n d^2 g sqrt(pi T/m) in 3D. Chapman & Cowling (1970) ch. 16.
double collision_rate(const Gas& gas);

/// Mean speed of a Maxwellian [length/time]: sqrt(pi T/(2m)) in 2D, sqrt(8T/(pi m)) in 3D.
double mean_speed(const Gas& gas);

/// Mean speed over collision rate [length]: 1/(2 sqrt(2) n d g) in 2D, 1/(sqrt(2) pi n d^2 g) in 3D.
double mean_free_path(const Gas& gas);

}  // namespace sandglass::law
