#pragma once

#include "sim/method/simulator.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass {

/// Maxwell's velocities at the granular temperature of the scene, the same for every species. If the scene wants it
/// exact, there is no momentum and precisely that temperature, N - 1 degrees of freedom an axis. Or components even over an
/// interval, if the scene says so.
template <int D>
void draw_velocities(Particles<D>& particles, const Scene& scene, const Streams& streams);

/// Adds to each component a number drawn evenly from within `bound` of zero.
template <int D>
void add_uniform_velocities(std::vector<Phase<D>>& particles, double bound, const Streams& streams);

/// Normal spins at the rotational granular temperature of the scene, zero where it has none; scaled to precisely that
/// temperature, N degrees of freedom a component, if the scene wants it exact.
template <int D>
void draw_spins(Particles<D>& particles, const Scene& scene, const Streams& streams);

}  // namespace sandglass
