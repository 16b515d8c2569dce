#pragma once

#include "sim/run/setup.hpp"

namespace sandglass {

/// Collisions per particle and time of hard particles of all species at one temperature, with the contact value of their
/// total fraction for every pair (kinetic theory after Enskog; exact for one species up to that value).
double enskog_rate(const Scene& scene, double temperature);

/// The wanted collisions per particle of the method's own kind, elastic and smooth, without gravity and between walls at
/// rest, before time zero. Throws InputError when they do not come.
template <int D>
void equilibrate(Particles<D>& particles, const Scene& scene, const Setup<D>& setup, const Streams& streams);

}  // namespace sandglass
