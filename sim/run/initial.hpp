#pragma once

#include "sim/run/setup.hpp"

#include <vector>

namespace sandglass {

/// Particles at time zero: placed, Maxwellian, equilibrated by elastic collisions if the scene asks for it, then set
/// moving with the stream and the shear wave. Throws InputError when the placement cannot be had.
template <int D>
Particles<D> initial_particles(const Scene& scene, const Setup<D>& setup, const Streams& streams);

}  // namespace sandglass
