#pragma once

namespace sandglass::law {

/// Pair correlation of elastic hard particles at contact, g(nu): Henderson (1975) for disks,
/// Carnahan & Starling (1969) for spheres. Fluid branch: nu below 0.70 (disks) or 0.49 (spheres).
double contact_value(int dimension, double fraction);

/// dg/dnu of contact_value.
double contact_value_slope(int dimension, double fraction);

/// B_k / B_2^(k-1) for k = 2..10, Clisby & McCoy (2006) table 1, with B2-B4 exact.
double virial_ratio(int dimension, int k);

/// g(nu) from the virial series up to B10. The terms left out are below 1e-4 of g for nu < 0.30 (disks) and
/// nu < 0.24 (spheres), where it is the sharper reference.
double virial_contact_value(int dimension, double fraction);

}  // namespace sandglass::law
