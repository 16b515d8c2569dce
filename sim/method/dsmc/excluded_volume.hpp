#pragma once

#include "sim/method/dsmc/cell_collisions.hpp"
#include "sim/method/dsmc/cell_entry.hpp"
#include "sim/observe/tally.hpp"

#include <map>
#include <string>

namespace sandglass::dsmc {

/// Excluded volume on the level of cells: full cells collide as a whole, take no particle in, and do not displace the
/// partners of their collisions (hybrid simulation Monte Carlo, Mueller 2001).
template <int D>
class ExcludedVolumeOfCells {
 public:
  /// Goes on to read the volumes of `cells`, which may change.
  ExcludedVolumeOfCells(const Parameters& parameters, const motion::MotionParameters<D>& motion,
                        const LatticeOfCells<D>& cells);

  /// The stage that lets full cells collide; to be asked for once.
  std::unique_ptr<CellStage<D>> take_stage() { return std::move(stage_); }
  void mark(std::span<const std::uint32_t> offsets) { full_.update(offsets); }
  /// Whether moves may be refused in this step: some cell is full, or entry is not certain.
  bool refuses() const { return full_.any() || !certain_entry_; }
  /// Per cell, not zero where it is full; null where none is.
  const std::uint8_t* full() const { return full_.any() ? full_.flags() : nullptr; }
  /// Per cell, not zero where partners are not displaced; null where all are.
  const std::uint8_t* still() const { return everywhere_ || !full_.any() ? nullptr : full_.flags(); }
  /// Whether the mean velocities of most cells are wanted.
  bool wants_means() const { return full_.many(); }
  /// Before the moves of a step; `key` names their draws.
  void begin_moves(std::span<const std::uint32_t> offsets, const StreamKey& key);
  void advance(ParticleStore<D>& store, std::uint32_t first_cell, std::uint32_t last_cell,
               const motion::MotionStep& step);

  std::map<std::string, double> counters() const;
  void save(Memory& memory) const;
  void load(const Memory& memory);
  std::size_t bytes() const { return full_.bytes() + entry_.bytes() + collisions_->bytes(); }

 private:
  void update_room(ParticleStore<D>& store, std::uint32_t moved);

  FullCells<D> full_;
  std::unique_ptr<CellCollisions<D>> stage_;
  CellCollisions<D>* collisions_;
  CellEntry<D> entry_;
  motion::CellEntries entries_ = {};
  std::unique_ptr<motion::EntryStage<D>> motion_;
  bool everywhere_, certain_entry_;
  bool room_updated_;               ///< planted fault: cells fill up as particles arrive, cell by cell
  std::vector<std::uint8_t> room_;  ///< with it, in place of the flags of `full_`
};

extern template class ExcludedVolumeOfCells<2>;
extern template class ExcludedVolumeOfCells<3>;

}  // namespace sandglass::dsmc
