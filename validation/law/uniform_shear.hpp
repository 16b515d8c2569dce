#pragma once

#include "validation/law/gas.hpp"

/// A gas in uniform shear: mean velocity along x, growing with y at a constant rate. It heats until dissipation takes
/// what shear brings, so the temperature of `Gas` is an outcome and its member is not read. Infinite for r = 1.
namespace sandglass::law {

/// Momentum flux over nT. The second normal stress of spheres, zz, equals yy to this order.
struct ReducedStress {
  double xx, yy;
  double xy;  ///< of the friction between layers, positive: minus the xy component
};

/// Relaxation rate of the traceless stress over nT/eta0, eta0 the elastic viscosity to first Sonine order:
/// h(5 - 3h)/2 for disks, h(2 - h) for spheres, h = (1+r)/2.
double stress_relaxation_ratio(int dimension, double restitution);

/// Shear rate over nT/eta0 of the dilute gas: sqrt(D z/(2b)) (b + z), with z the cooling rate and b + z the
/// stress relaxation over nT/eta0. Grad's method, linear in the stress: Brey, Ruiz-Montero & Moreno 1997.
double dilute_shear_rate(int dimension, double restitution);
/// xx = (b + Dz)/(b + z), yy = b/(b + z), xy = sqrt(Dbz/2)/(b + z); the same source.
ReducedStress dilute_shear_stress(int dimension, double restitution);
/// Granular temperature of the dilute gas; proportional to the rate squared [mass length^2 time^-2].
double dilute_shear_temperature(const Gas& gas, double rate);

/// Shear viscosity of the dense inelastic gas at the temperature of `gas` [mass length^(2-D) time^-1]. Spheres: Lun,
/// Savage, Jeffrey & Chepurniy 1984. Disks: the same derivation, Jenkins & Richman 1985 as r -> 1. First order in the
/// shear rate.
double inelastic_shear_viscosity(const Gas& gas);
/// Temperature at which viscosity times rate^2 is the rate of dissipation (D/2) n T zeta [mass length^2 time^-2].
double shear_temperature(const Gas& gas, double rate);
/// Shear stress, viscosity times rate at that temperature [mass length^(2-D) time^-2].
double shear_stress(const Gas& gas, double rate);
/// Isotropic pressure nTZ at that temperature [mass length^(2-D) time^-2].
double shear_pressure(const Gas& gas, double rate);

}  // namespace sandglass::law
