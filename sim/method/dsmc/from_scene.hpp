#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/motion/parameters.hpp"
#include "sim/scene/scene.hpp"
#include "sim/space/grid.hpp"

namespace sandglass::dsmc {

/// Throws InputError for more cells than can be numbered.
template <int D>
Grid<D> grid_of(const Scene& scene);
template <int D>
Parameters parameters_of(const Scene& scene);
template <int D>
motion::MotionParameters<D> motion_of(const Scene& scene);

extern template Grid<2> grid_of(const Scene&);
extern template Grid<3> grid_of(const Scene&);
extern template Parameters parameters_of<2>(const Scene&);
extern template Parameters parameters_of<3>(const Scene&);
extern template motion::MotionParameters<2> motion_of(const Scene&);
extern template motion::MotionParameters<3> motion_of(const Scene&);

}  // namespace sandglass::dsmc
