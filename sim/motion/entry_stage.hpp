#pragma once

#include "sim/motion/motion_stage.hpp"

namespace sandglass::motion {

/// Which cells take in particles of other cells during a step. All that it says is known before the first move, so that no
/// order of work can show.
struct CellEntries {
  const std::uint8_t* full;  ///< per cell, and for those who leave the box: not zero where nobody comes in
  const float* probability = nullptr;  ///< of coming into each that is not full; null: one
  StreamKey key = {};                  ///< of the draws, one a particle, named by stream_index()
  bool within_too = false;  ///< moves that begin in the full cell where they end are refused as well
};

/// Free flight over one step where moves into cells may be refused, in one pass. A refused particle keeps place,
/// velocity and cell, and gets no gravity; a place that an offset has taken out of the cell is moved back to its edge.
template <int D>
class EntryStage {
 public:
  virtual ~EntryStage() = default;
  /// Advances the particles of cells [first, last) and counts them into the cells where they arrive; how many were refused.
  virtual std::uint64_t advance(ParticleStore<D>& store, std::uint32_t first, std::uint32_t last,
                                const MotionStep& step, const CellEntries& entries) const = 0;
};

template <int D>
std::unique_ptr<EntryStage<D>> make_entry_stage(const MotionParameters<D>& parameters, const Vector<D>& box);

template <>
std::unique_ptr<EntryStage<2>> make_entry_stage(const MotionParameters<2>& parameters, const Vector<2>& box);
template <>
std::unique_ptr<EntryStage<3>> make_entry_stage(const MotionParameters<3>& parameters, const Vector<3>& box);

}  // namespace sandglass::motion
