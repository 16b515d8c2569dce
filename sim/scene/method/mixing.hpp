#pragma once

#include "sim/scene/scene.hpp"

namespace sandglass {

/// What particles do to each other at a distance; null where they do nothing before they touch or collide.
const MixingOptions* repulsion_in(const Scene& scene);

}  // namespace sandglass
