#pragma once

#include "sim/scene/scene.hpp"

#include <cmath>

namespace sandglass {

/// Square of the mean speed of a Maxwellian gas with T/m = 1: pi/2 in two dimensions, 8/pi in three.
inline double squared_mean_speed(int dimension) { return dimension == 2 ? M_PI / 2 : 8 / M_PI; }
/// Mean speed of a Maxwellian gas from sqrt(T/m).
double mean_speed(int dimension, double thermal_speed);
/// sqrt(T/m) of the initial state, m of the first species.
double thermal_speed(const Scene& scene);

/// Collisions per particle and time of a dilute gas of all the scene's species, at this granular temperature and the scene's
/// mean density.
double rate_of_points(const Scene& scene, double temperature);
/// Enskog's collisions per particle and time of a gas of hard particles of all the scene's species, at this granular
/// temperature and the scene's mean density.
double enskog_rate(const Scene& scene, double temperature);

}  // namespace sandglass
