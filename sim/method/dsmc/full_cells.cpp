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
  const auto mark = [offsets, full = std::span(full_)](auto capacity) {
    std::uint32_t count = 0;
    for (std::uint32_t cell = 0; cell + 1 < full.size(); ++cell) {
      full[cell] = offsets[cell + 1] - offsets[cell] >= capacity(cell);
      count += full[cell];
    }
    return count;
  };
  count_ = volumes_.empty() ? mark([whole = whole_](std::uint32_t) { return whole; })
                            : mark([this](std::uint32_t cell) { return capacity(cell); });
  many_ = 4.0 * count_ * whole_ > offsets.back();
}

template class FullCells<2>;
template class FullCells<3>;

}  // namespace sandglass::dsmc
