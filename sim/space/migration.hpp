#pragma once

#include "sim/space/particle_store.hpp"
#include "sim/space/shared_cells.hpp"

namespace sandglass {

/// Instead of ParticleStore::sort(): takes particles to the rank that works on the cell where they have arrived, however far
/// away that is. Within a cell they then stand in the order of (old cell, old place), as if one process held them all.
template <int D>
void migrate_and_sort(ParticleStore<D>& store, const SharedCells& cells);

/// The particles of all ranks on the first of them, in the order of their cells, into `all`; elsewhere it is left alone.
template <int D>
void gather(const ParticleStore<D>& store, const SharedCells& cells, ParticleStore<D>& all);

}  // namespace sandglass
