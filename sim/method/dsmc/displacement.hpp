#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/physics/collision.hpp"

namespace sandglass::dsmc {

/// Displacement of the first partner of a collision; the second gets the opposite. Consistent Boltzmann algorithm
/// (Alexander, Garcia & Alder 1995): a length along its momentum change, of direction `normal`. Generalized form
/// (Garcia, Alexander & Alder 1997): an extra one of zero mean.
template <int D>
[[gnu::always_inline]] inline Vector<D> displacement(const Offset& offset, const Vector<D>& normal,
                                                     Random& random) {
  if (offset.random == 0) [[likely]]
    return offset.consistent * normal;
  return offset.consistent * normal + offset.random * uniform_direction<D>(random);
}

}  // namespace sandglass::dsmc
