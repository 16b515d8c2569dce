#include "sim/method/dsmc/full_cells.hpp"

#include "sim/method/dsmc/local_factor.hpp"

#include <algorithm>
#include <limits>

namespace sandglass::dsmc {

std::uint32_t most_in_cell(int dimension, const Parameters& parameters, double cell_volume) {
  const double one = parameters.weight * particle_volume(dimension, parameters.diameter) / cell_volume;
  // A whole number that division has left a little short is meant.
  const double most = std::floor(parameters.excluded_volume.densest / one * (1 + 1e-12));
  return static_cast<std::uint32_t>(
      std::min(most, static_cast<double>(std::numeric_limits<std::uint32_t>::max())));
}

template <int D>
FullCells<D>::FullCells(const Parameters& parameters, const LatticeOfCells<D>& cells)
    : parameters_(parameters),
      cell_volume_(cells.grid().cell_volume()),
      whole_(most_in_cell(D, parameters, cell_volume_)),
      volumes_(cells.volumes()),
      full_(cells.size() + 1) {}

template <int D>
void FullCells<D>::update(std::span<const std::uint32_t> offsets) {
  any_ = false;
  for (std::uint32_t cell = 0; cell + 1 < full_.size(); ++cell) {
    full_[cell] = offsets[cell + 1] - offsets[cell] >= capacity(cell);
    any_ |= full_[cell] != 0;
  }
}

template class FullCells<2>;
template class FullCells<3>;

}  // namespace sandglass::dsmc
