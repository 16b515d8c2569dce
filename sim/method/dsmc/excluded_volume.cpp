#include "sim/method/dsmc/excluded_volume.hpp"

#include "sim/base/saved.hpp"

namespace sandglass::dsmc {

template <int D>
ExcludedVolumeOfCells<D>::ExcludedVolumeOfCells(const Parameters& parameters,
                                                const motion::MotionParameters<D>& motion,
                                                const LatticeOfCells<D>& cells)
    : full_(parameters, cells),
      stage_(std::make_unique<CellCollisions<D>>(parameters, cells, full_)),
      collisions_(stage_.get()),
      entry_(parameters, cells, full_),
      motion_(motion::make_entry_stage<D>(motion, cells.grid().box())),
      everywhere_(parameters.excluded_volume.offset_in_full_cells),
      certain_entry_(parameters.excluded_volume.entry.empty()),
      room_updated_(parameters.faults.room_updated) {}

template <int D>
void ExcludedVolumeOfCells<D>::begin_moves(std::span<const std::uint32_t> offsets, const StreamKey& key) {
  entries_ = entry_.entries(offsets, key);
  if (!room_updated_) return;
  room_.assign(entries_.full, entries_.full + offsets.size());
  entries_.full = room_.data();
}

template <int D>
void ExcludedVolumeOfCells<D>::advance(ParticleStore<D>& store, std::uint32_t first_cell,
                                       std::uint32_t last_cell, const motion::MotionStep& step) {
  if (!room_updated_) {
    entry_.refused() += motion_->advance(store, first_cell, last_cell, step, entries_);
    return;
  }
  for (std::uint32_t cell = first_cell; cell < last_cell; ++cell) {
    entry_.refused() += motion_->advance(store, cell, cell + 1, step, entries_);
    update_room(store, cell);
  }
}

/// Cells behind the one that has moved still hold all that they held.
template <int D>
void ExcludedVolumeOfCells<D>::update_room(ParticleStore<D>& store, std::uint32_t moved) {
  const auto offsets = store.offsets();
  const auto update = [&](std::uint32_t cell) {
    if (cell == store.removed()) return;
    const std::uint32_t held =
        store.arrivals()[cell] + (cell > moved ? offsets[cell + 1] - offsets[cell] : 0);
    room_[cell] = held >= full_.capacity(cell);
  };
  update(moved);
  for (std::uint32_t i = offsets[moved]; i < offsets[moved + 1]; ++i) update(store.places()[i].cell);
}

template <int D>
std::map<std::string, double> ExcludedVolumeOfCells<D>::counters() const {
  const CellCollisionCount& count = collisions_->count();
  return {{"cell-collisions", count.collisions},
          {"cell-heat", count.heat},
          {"cell-heat-lost", count.heat_lost},
          {"moves-refused", static_cast<double>(entry_.refused())}};
}

template <int D>
void ExcludedVolumeOfCells<D>::save(Memory& memory) const {
  const CellCollisionCount& count = collisions_->count();
  memory["dsmc/cells"] = {count.collisions, count.heat, count.heat_lost,
                          static_cast<double>(entry_.refused())};
}

template <int D>
void ExcludedVolumeOfCells<D>::load(const Memory& memory) {
  const std::vector<double>& counts = memory.at("dsmc/cells");
  collisions_->count() = {counts.at(0), counts.at(1), counts.at(2)};
  entry_.refused() = saved_count(counts.at(3));
}

template class ExcludedVolumeOfCells<2>;
template class ExcludedVolumeOfCells<3>;

}  // namespace sandglass::dsmc
