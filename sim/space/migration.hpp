#pragma once

#include "sim/space/particle_store.hpp"
#include "sim/space/shared_cells.hpp"

namespace sandglass {

/// Takes particles to the rank that works on the cell where they have arrived, however far away that is. Within a cell they
/// then stand in the order of (old cell, old place), as if one process held them all.
template <int D>
class Migration {
 public:
  explicit Migration(std::uint32_t cells) : from_below_(cells) {}

  /// Between motion and sort.
  void apply(ParticleStore<D>& store, const SharedCells& cells);
  std::size_t bytes() const { return from_below_.capacity() * sizeof(std::uint32_t); }

 private:
  using Bytes = Communicator::Bytes;

  std::vector<Bytes> take_leaving(ParticleStore<D>& store, const SharedCells& cells);
  void make_room_for(ParticleStore<D>& store, const SharedCells& cells, std::span<const Bytes> from_below);

  std::vector<std::uint32_t> from_below_;  ///< arrivals from lower ranks, by cell
};

/// The particles of all ranks on the first of them, in the order of their cells, into `all`; elsewhere it is left alone.
template <int D>
void gather(const ParticleStore<D>& store, const SharedCells& cells, ParticleStore<D>& all);

extern template class Migration<2>;
extern template class Migration<3>;

}  // namespace sandglass
