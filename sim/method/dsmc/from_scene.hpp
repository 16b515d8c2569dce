#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/scene/scene.hpp"
#include "sim/space/lattice_of_cells.hpp"

namespace sandglass::dsmc {

/// With `particles_per_cell` where the scene does not say how large cells are. Throws InputError for more cells than can
/// be numbered.
template <int D>
LatticeOfCells<D> cells_of(const Scene& scene, double particles_per_cell);
template <int D>
Parameters parameters_of(const Scene& scene);

extern template LatticeOfCells<2> cells_of(const Scene&, double);
extern template LatticeOfCells<3> cells_of(const Scene&, double);
extern template Parameters parameters_of<2>(const Scene&);
extern template Parameters parameters_of<3>(const Scene&);

}  // namespace sandglass::dsmc
