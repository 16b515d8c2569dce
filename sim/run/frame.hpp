#pragma once

#include "sim/observe/view.hpp"
#include "sim/record/record.hpp"
#include "sim/space/particles.hpp"

namespace sandglass {

/// All that the view shows of the particles, for a file.
template <int D>
Frame frame_of(const View<D>& view);

/// Back again, for a restart.
template <int D>
Particles<D> particles_of(const Frame& frame);

}  // namespace sandglass
