#include "sim/method/dsmc/excluded_volume.hpp"

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
      in_order_(parameters.faults.room_updated
                    ? std::make_unique<motion::RefusableMotion<D>>(motion, cells.grid().box())
                    : nullptr),
      everywhere_(parameters.excluded_volume.offset_in_full_cells),
      certain_entry_(parameters.excluded_volume.entry.empty()) {}

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
  entry_.refused() = static_cast<std::uint64_t>(counts.at(3));
}

template class ExcludedVolumeOfCells<2>;
template class ExcludedVolumeOfCells<3>;

}  // namespace sandglass::dsmc
