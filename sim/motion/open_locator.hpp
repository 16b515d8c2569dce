#pragma once

#include "sim/motion/free_flight.hpp"
#include "sim/space/cell_locator.hpp"

namespace sandglass::motion {

/// The cell where a flight ends in a box with open sides; ParticleStore::removed() for who has left. Nobody else is
/// outside the box: what a moving wall has carried out counts as at its edge.
template <int D>
class OpenLocator {
 public:
  using Real = typename CellLocator<D>::Real;

  explicit OpenLocator(const Grid<D>& grid)
      : cells_(grid), box_(Lanes<D>::from(grid.box(), HUGE_VAL)), removed_(grid.size()) {}

  std::uint32_t cell_of(const Real& position) const {
    return all<D>((position >= 0) & (position <= box_)) ? cells_.cell_of(position) : removed_;
  }

 private:
  CellLocator<D> cells_;
  Real box_;
  std::uint32_t removed_;
};

}  // namespace sandglass::motion
