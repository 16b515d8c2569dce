#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/space/lattice_of_cells.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sandglass::dsmc {

/// Simulated particles that a cell of this volume holds at most; 0 where not even one fits.
std::uint32_t most_in_cell(int dimension, const Parameters& parameters, double cell_volume);

/// Which cells have no room for one more particle below the densest packing (Mueller 2001, 2.3.2). Marked once at the
/// start of a step and not again within it, so that no order of work can show.
template <int D>
class FullCells {
 public:
  /// Goes on to read the volumes of `cells`, which may change.
  FullCells(const Parameters& parameters, const LatticeOfCells<D>& cells);

  /// `offsets` as of ParticleStore.
  void update(std::span<const std::uint32_t> offsets);
  bool any() const { return count_ > 0; }
  /// Whether full cells and their neighbours are most of those that hold something: full ones hold a quarter of the
  /// particles or more.
  bool many() const { return many_; }
  /// Also of ParticleStore::removed().
  bool full(std::uint32_t cell) const { return full_[cell] != 0; }
  const std::uint8_t* flags() const { return full_.data(); }
  /// Particles that fill a cell.
  std::uint32_t capacity(std::uint32_t cell) const {
    return volumes_.empty() ? whole_ : most_in_cell(D, parameters_, cell_volume_ * volumes_[cell]);
  }
  std::size_t bytes() const { return full_.capacity(); }

 private:
  Parameters parameters_;
  double cell_volume_;
  std::uint32_t whole_;              ///< particles that fill a whole cell
  std::span<const double> volumes_;  ///< as of LatticeOfCells
  std::uint32_t count_ = 0;          ///< of full cells
  bool many_ = false;
  std::vector<std::uint8_t> full_;  ///< by cell, and one more that never is: where particles leave
};

extern template class FullCells<2>;
extern template class FullCells<3>;

}  // namespace sandglass::dsmc
