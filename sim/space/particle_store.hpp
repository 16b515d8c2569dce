#pragma once

#include "sim/space/grid.hpp"
#include "sim/space/huge_page_allocator.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sandglass {

/// A point of phase space: what every particle has.
template <int D>
struct Phase {
  Vector<D> position, velocity;
};

template <class T>
using Column = std::vector<T, HugePageAllocator<T>>;

/// Particles sorted by cell, with a second buffer for the counting sort of every step. Within a cell the order is that of
/// (old cell, old place): it does not depend on how cells are shared out. The id column exists only if asked for.
template <int D>
class ParticleStore {
 public:
  ParticleStore(const Grid<D>& grid, bool keep_ids)
      : grid_(grid), keep_ids_(keep_ids), offset_(grid.size() + 1) {}

  const Grid<D>& grid() const { return grid_; }
  std::size_t size() const { return phase_.size(); }
  bool keeps_ids() const { return keep_ids_; }

  std::span<Phase<D>> phases() { return phase_; }
  std::span<const Phase<D>> phases() const { return phase_; }
  std::span<const std::uint64_t> ids() const { return id_; }
  /// First particle of each cell; one more entry than cells.
  std::span<const std::uint32_t> offsets() const { return offset_; }

  /// Place of each particle after the coming sort: its cell and its rank among the arrivals there. The motion fills it in
  /// with arrive(); sort() then knows every address beforehand and waits for no counter.
  struct Place {
    std::uint32_t cell, rank;
  };
  void begin_step() { std::fill(arrival_.begin(), arrival_.end(), 0u); }
  /// For the motion's inner loop: places of the particles and counters of arrivals by cell.
  Place* places() { return place_.data(); }
  std::uint32_t* arrivals() { return arrival_.data() + 1; }
  /// Moves every particle to its place.
  void sort();

  /// Takes particles in the given order, numbers them if ids are kept (or takes `ids`), and sorts them into cells.
  void assign(std::span<const Phase<D>> particles, std::span<const std::uint64_t> ids = {});

  /// Bytes that the store holds, by what is allocated.
  std::size_t bytes() const;

 private:
  Grid<D> grid_;
  bool keep_ids_;
  Column<Phase<D>> phase_, next_phase_;
  Column<std::uint64_t> id_, next_id_;
  Column<Place> place_;
  std::vector<std::uint32_t> offset_, arrival_ = std::vector<std::uint32_t>(offset_.size());
};

extern template class ParticleStore<2>;
extern template class ParticleStore<3>;

}  // namespace sandglass
