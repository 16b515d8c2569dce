#include "sim/method/region_weights.hpp"

#include "sim/method/grid_from_scene.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// Middle of a cell, in cells.
template <int D>
Vector<D> middle_of(const Grid<D>& grid, std::uint32_t cell) {
  Vector<D> middle;
  for (int axis = 0; axis < D; ++axis) {
    middle[axis] = cell % grid.cells(axis) + 0.5;
    cell /= grid.cells(axis);
  }
  return middle;
}

template <int D>
bool holds(const Region& region, const Vector<D>& position) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double x = position[static_cast<int>(axis)];
    if (x < region.low[axis] || x > region.high[axis]) return false;
  }
  return true;
}
}  // namespace

template <int D>
RegionWeights<D>::RegionWeights(const Scene& scene, const Grid<D>& grid)
    : grid_(grid), weights_(grid.size(), scene.method.weight) {
  for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
    Vector<D> middle = middle_of(grid, cell);
    for (int axis = 0; axis < D; ++axis) middle[axis] /= grid.cells_per_length(axis);
    const auto found =
        std::ranges::find_if(scene.regions, [&](const Region& region) { return holds<D>(region, middle); });
    if (found != scene.regions.end()) weights_[cell] = found->weight;
  }
}

template <int D>
RegionWeights<D>::RegionWeights(const Scene& scene)
    : RegionWeights(scene, grid_of_cells<D>(scene, cells_along(scene))) {}

template <int D>
double RegionWeights<D>::lightest() const {
  return *std::ranges::min_element(weights_);
}

template <int D>
double RegionWeights<D>::mean_inverse() const {
  double sum = 0;
  for (const double weight : weights_) sum += 1 / weight;
  return sum / static_cast<double>(weights_.size());
}

template <int D>
typename RegionWeights<D>::Side RegionWeights<D>::along(int axis, bool high) const {
  Side side{HUGE_VAL, 0};
  double cells = 0;
  for (std::uint32_t cell = 0; cell < grid_.size(); ++cell) {
    const double place = middle_of(grid_, cell)[axis];
    if (high ? place < grid_.cells(axis) - 1 : place > 1) continue;
    side.lightest = std::min(side.lightest, weights_[cell]);
    side.mean_inverse += 1 / weights_[cell];
    ++cells;
  }
  side.mean_inverse /= cells;
  return side;
}

template class RegionWeights<2>;
template class RegionWeights<3>;

}  // namespace sandglass
