#pragma once

#include "sim/run/setup.hpp"

namespace sandglass {

/// Elastic collisions without a drive, as many per particle as the scene asks for before time zero. Throws InputError
/// when particles do not collide.
template <int D>
void equilibrate(Particles<D>& particles, const Setup<D>& setup, const Streams& streams);

}  // namespace sandglass
