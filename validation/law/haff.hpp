#pragma once

#include "validation/law/gas.hpp"

namespace sandglass::law {

/// zeta = -(dT/dt)/T = (1-r^2) omega/D of a homogeneous Maxwellian gas [1/time].
double cooling_rate(const Gas& gas);

/// cooling_rate with the first Sonine correction 1 + 3 a2/16, van Noije & Ernst (1998).
double cooling_rate_sonine(const Gas& gas);

/// t0 = 2/zeta = 2D/((1-r^2) omega), Haff (1983) [time]. Infinite for r = 1 or an empty gas.
double haff_time_scale(const Gas& gas);

/// 2/cooling_rate_sonine [time]; holds once a2 has settled, after a few collisions per particle.
double haff_time_scale_sonine(const Gas& gas);

/// E(t)/E(0) = (1 + t/t0)^-2.
double haff_energy_ratio(double time, double time_scale);

/// Collisions per particle up to `time`: omega(0) t0 ln(1 + t/t0).
double haff_collisions(double initial_rate, double time, double time_scale);

/// E/E(0) after tau collisions per particle: exp(-(1-r^2) tau/D).
double haff_energy_ratio_of_collisions(int dimension, double restitution, double collisions);

}  // namespace sandglass::law
