#pragma once

#include "sim/motion/parameters.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass {

/// Walls, obstacles and gravity of a scene for particles that touch them with their centre.
template <int D>
motion::MotionParameters<D> motion_of(const Scene& scene);

extern template motion::MotionParameters<2> motion_of(const Scene&);
extern template motion::MotionParameters<3> motion_of(const Scene&);

}  // namespace sandglass
