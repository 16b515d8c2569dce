#pragma once

#include <array>

namespace sandglass::law {

/// q of I = q m R^2 of a solid disk, 1/2, or ball, 2/5, about its centre.
inline double solid_inertia(int dimension) { return dimension == 2 ? 1.0 / 2 : 2.0 / 5; }

/// A uniform gas of equal rough particles, and what a contact does to it.
struct RoughGas {
  int dimension = 3;
  double restitution = 1;   ///< e, 0..1
  double tangential = -1;   ///< e_t: -1 smooth, 1 perfectly rough (Kawasaki 1986: eps_s = -e_t)
  double inertia = 2. / 5;  ///< q of I = q m R^2
};

/// Granular temperatures of translation and rotation, per degree of freedom.
struct Temperatures {
  double translation = 1, rotation = 1;
};

/// Energy that translation and rotation of a pair gain in one collision, mean over the collisions of a Maxwellian gas whose
/// spins are normal and independent of the velocities (Huthmann & Zippelius 1997; Luding et al. 1998):
///   dE_tr  = -(1 - e^2) T_t - 2 N eta (1 - eta) T_t + 2 N (eta^2/q) T_r
///   dE_rot = 2 N (eta^2/q) T_t - 2 N (eta/q)(1 - eta/q) T_r,   eta = q (1 + e_t)/(2 q + 2), N = D - 1.
Temperatures rough_energy_change(const RoughGas& gas, const Temperatures& now);

/// After tau collisions per particle from `start`. With D dT_t/dtau = dE_tr and dT_r/dtau = dE_rot over 1 (2D) or 3 (3D)
/// the temperatures follow a linear equation.
Temperatures rough_cooling(const RoughGas& gas, const Temperatures& start, double collisions);

/// After the time `mean_free_times`, counted in mean free times of the start, from T_t = 1: d tau/dt = sqrt(T_t).
Temperatures rough_cooling_in_time(const RoughGas& gas, const Temperatures& start, double mean_free_times);

/// T_r/T_t after many collisions: of the slower mode. Infinite for smooth inelastic particles, whose spins stay.
double rough_temperature_ratio(const RoughGas& gas);

}  // namespace sandglass::law
