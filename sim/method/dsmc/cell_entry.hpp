#pragma once

#include "sim/method/dsmc/full_cells.hpp"
#include "sim/motion/entry_stage.hpp"

namespace sandglass::dsmc {

/// Refuses moves into full cells, and into others with the probability that the table of entry leaves. The room of a cell
/// is that of the start of the step, however many enter (Mueller 2001, 4.2.1).
///
/// Within a full cell particles move, as its edges hold them. Edges that are elsewhere in every step hold nobody: most
/// moves would cross none, and a column at rest would fall through them. Where cells are displaced, moves that end in a
/// full cell are therefore refused from wherever they come.
template <int D>
class CellEntry {
 public:
  /// Goes on to read the volumes of `cells`, which may change.
  CellEntry(const Parameters& parameters, const LatticeOfCells<D>& cells, const FullCells<D>& full);

  /// For the flight; the probabilities are those of particles that stand as `offsets` says. `key` names their draws.
  motion::CellEntries entries(std::span<const std::uint32_t> offsets, const StreamKey& key);

  std::uint64_t& refused() { return refused_; }
  std::uint64_t refused() const { return refused_; }
  std::size_t bytes() const { return probability_.capacity() * sizeof(float); }

 private:
  void look_up(std::span<const std::uint32_t> offsets);

  const FullCells<D>& full_;
  Curve entry_;
  double fraction_per_particle_;     ///< in a whole cell
  std::span<const double> volumes_;  ///< as of LatticeOfCells
  bool within_;                      ///< moves within a full cell are refused too
  std::vector<float> probability_;   ///< to enter each cell; empty where it is one
  std::uint64_t refused_ = 0;        ///< moves since time zero
};

extern template class CellEntry<2>;
extern template class CellEntry<3>;

}  // namespace sandglass::dsmc
