#pragma once

#include "validation/law/gas.hpp"

namespace sandglass::law {

/// An expectation and how well it is known.
struct Bounded {
  double value = 0;
  double standard_error = 0;  ///< of the published numbers behind it
  double bound = 0;           ///< on what is left out
};

/// Z = p/(nT) of the elastic fluid: (1-nu)^D Z as a polynomial in nu to nu^9 (rescaled virial expansion, Baus &
/// Colot 1987) with the coefficients of virial_ratio. Standard error from theirs, bound = the last term kept.
/// Good to 0.05% up to nu = 0.60 (disks) and 0.2% up to 0.49 (spheres). Near freezing of disks it is not: 0.5% too
/// large at 0.65 and 6% at 0.69 (Erpenbeck & Luban 1985; event chains of ours), which the bound cannot know.
Bounded virial_compressibility(int dimension, double fraction);

/// g = (Z-1)/(2^(D-1) nu), the contact value of the elastic fluid as well as it is known: the rescaled virial
/// expansion up to nu = 0.60 (disks) and 0.49 (spheres); between 0.60 and 0.66 Henderson's g less
/// nu^3/(128 (1-nu)^4), Luding (2001), good to 0.2%. Not a number beyond.
Bounded reference_contact_value(int dimension, double fraction);

/// Z of the gas with the reference contact value; the collisional part carries (1+r)/2.
Bounded reference_compressibility(const Gas& gas);

/// Collisions per particle and time with the reference contact value [1/time]: exact for r = 1.
Bounded reference_collision_rate(const Gas& gas);

}  // namespace sandglass::law
