#include "sim/method/grid_from_scene.hpp"

#include "sim/base/error.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double kMostCells = 2147483647;  // as many as a scene may name
}  // namespace

double edge_for(const Scene& scene, double particles_per_cell) {
  const double particles = static_cast<double>(std::max<std::uint64_t>(particle_count(scene), 1));
  return std::pow(volume(scene.domain) * particles_per_cell / particles, 1.0 / scene.domain.dimension);
}

template <int D>
Grid<D> grid_of_cells(const Scene& scene, const std::vector<double>& cells) {
  std::array<std::uint32_t, D> numbers;
  double total = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    total *= cells[axis];
    if (total > kMostCells)
      throw InputError(
          fmt::format("the scene asks for {:.4g} cells or more, and at most {:.0f} are allowed; raise "
                      "'method.cell-size' or "
                      "lower 'method.cells'",
                      total, kMostCells));
    numbers[axis] = static_cast<std::uint32_t>(cells[axis]);
  }
  return Grid<D>(vector_of<D>(scene.domain.size), numbers);
}

template <int D>
Grid<D> grid_of_edge(const Scene& scene, double edge) {
  return grid_of_cells<D>(scene, cells_of_edge(scene, edge));
}

template Grid<2> grid_of_cells(const Scene&, const std::vector<double>&);
template Grid<3> grid_of_cells(const Scene&, const std::vector<double>&);
template Grid<2> grid_of_edge(const Scene&, double);
template Grid<3> grid_of_edge(const Scene&, double);

}  // namespace sandglass
