#pragma once

#include "sim/scene/scene.hpp"
#include "sim/space/grid.hpp"

namespace sandglass {

/// So many cells along each axis. Throws InputError for more than can be numbered.
template <int D>
Grid<D> grid_of_cells(const Scene& scene, const std::vector<double>& cells);

/// Cells with an edge near the wanted one: the nearest whole number of them along each axis, at least one.
template <int D>
Grid<D> grid_of_edge(const Scene& scene, double edge);

/// Edge of cells that hold so many simulated particles in the mean.
double edge_for(const Scene& scene, double particles_per_cell);

extern template Grid<2> grid_of_cells(const Scene&, const std::vector<double>&);
extern template Grid<3> grid_of_cells(const Scene&, const std::vector<double>&);
extern template Grid<2> grid_of_edge(const Scene&, double);
extern template Grid<3> grid_of_edge(const Scene&, double);

}  // namespace sandglass
