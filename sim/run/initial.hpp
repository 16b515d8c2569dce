#pragma once

#include "sim/run/setup.hpp"

#include <vector>

namespace sandglass {

/// Particles at time zero. Those that the scene gives are taken as they are; others are placed, Maxwellian, equilibrated
/// by elastic collisions if the scene asks for it, then set moving with the stream and the shear wave. Species are given
/// where there are several, spins where contacts are rough. None for a method without
/// particles. Throws InputError when the state cannot be had.
template <int D>
Particles<D> initial_particles(const Setup<D>& setup, const Streams& streams);

}  // namespace sandglass
