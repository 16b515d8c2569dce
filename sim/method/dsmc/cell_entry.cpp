#include "sim/method/dsmc/cell_entry.hpp"

#include "sim/method/dsmc/local_factor.hpp"

namespace sandglass::dsmc {

template <int D>
CellEntry<D>::CellEntry(const Parameters& parameters, const LatticeOfCells<D>& cells,
                        const FullCells<D>& full)
    : full_(full),
      entry_(parameters.excluded_volume.entry),
      fraction_per_particle_(parameters.weight * particle_volume(D, parameters.diameter) /
                             cells.grid().cell_volume()),
      volumes_(cells.volumes()),
      within_(cells.shifted_cells().has_value()) {}

template <int D>
motion::CellEntries CellEntry<D>::entries(std::span<const std::uint32_t> offsets, const StreamKey& key) {
  if (!entry_.empty()) look_up(offsets);
  return {full_.flags(), probability_.empty() ? nullptr : probability_.data(), key, within_};
}

template <int D>
void CellEntry<D>::look_up(std::span<const std::uint32_t> offsets) {
  probability_.assign(offsets.size(), 1);  // the last: out of the box
  for (std::uint32_t cell = 0; cell + 1 < offsets.size(); ++cell) {
    const double fraction = (offsets[cell + 1] - offsets[cell]) * fraction_per_particle_;
    probability_[cell] =
        static_cast<float>(entry_.at(volumes_.empty() ? fraction : fraction / volumes_[cell]));
  }
}

template class CellEntry<2>;
template class CellEntry<3>;

}  // namespace sandglass::dsmc
