#include "sim/method/dsmc/cell_entry.hpp"

#include "sim/method/dsmc/local_factor.hpp"
#include "sim/motion/stream_index.hpp"

namespace sandglass::dsmc {

template <int D>
CellEntry<D>::CellEntry(const Parameters& parameters, const LatticeOfCells<D>& cells,
                        const FullCells<D>& full)
    : full_(full),
      entry_(parameters.excluded_volume.entry),
      fraction_per_particle_(parameters.weight * particle_volume(D, parameters.diameter) /
                             cells.grid().cell_volume()),
      volumes_(cells.volumes()),
      in_order_(parameters.faults.room_updated),
      within_(cells.shifted_cells().has_value()) {}

template <int D>
void CellEntry<D>::decide(const motion::Proposals<D>& moves) {
  if (in_order_) return decide_in_order(moves);
  if (!entry_.empty()) look_up(moves);
  for (std::uint32_t cell = 0; cell + 1 < moves.offsets.size(); ++cell)
    for (std::uint32_t i = moves.offsets[cell]; i < moves.offsets[cell + 1]; ++i)
      if ((within_ || moves.targets[i] != cell) && !admits(cell, i - moves.offsets[cell], moves.targets[i])) {
        moves.refused[i] = 1;
        ++refused_;
      }
}

template <int D>
void CellEntry<D>::look_up(const motion::Proposals<D>& moves) {
  probability_.assign(moves.cells.size() + 1, 1);  // the last: out of the box
  for (std::uint32_t cell = 0; cell < moves.cells.size(); ++cell) {
    const double fraction = (moves.offsets[cell + 1] - moves.offsets[cell]) * fraction_per_particle_;
    probability_[cell] =
        static_cast<float>(entry_.at(volumes_.empty() ? fraction : fraction / volumes_[cell]));
  }
}

template <int D>
bool CellEntry<D>::admits(std::uint32_t from, std::uint32_t place, std::uint32_t target) const {
  if (full_.full(target)) return false;
  if (target == from) return true;
  if (probability_.empty() || probability_[target] >= 1) return true;
  return Random(key_, motion::stream_index(from, place)).uniform() < probability_[target];
}

/// The planted fault Faults::room_updated.
template <int D>
void CellEntry<D>::decide_in_order(const motion::Proposals<D>& moves) {
  std::vector<std::uint32_t> held(moves.cells.size());
  for (std::uint32_t cell = 0; cell < held.size(); ++cell)
    held[cell] = moves.offsets[cell + 1] - moves.offsets[cell];
  for (std::uint32_t cell = 0; cell < held.size(); ++cell)
    for (std::uint32_t i = moves.offsets[cell]; i < moves.offsets[cell + 1]; ++i) {
      const std::uint32_t target = moves.targets[i];
      if (target == cell || target == moves.cells.size()) continue;
      moves.refused[i] = held[target] >= full_.capacity(target);
      if (moves.refused[i])
        ++refused_;
      else
        --held[cell], ++held[target];
    }
}

template class CellEntry<2>;
template class CellEntry<3>;

}  // namespace sandglass::dsmc
