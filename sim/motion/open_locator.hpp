#pragma once

#include "sim/motion/free_flight.hpp"
#include "sim/space/cell_locator.hpp"

namespace sandglass::motion {

/// The cell where a flight ends in a box with open sides; ParticleStore::removed() for who has left. Nobody else is
/// outside the box: what a moving wall has carried out counts as at its edge. `InBox` finds the cells of the others.
template <int D, class InBox>
class OpenLocator {
 public:
  using Real = typename Lanes<D>::Real;

  explicit OpenLocator(const LatticeOfCells<D>& cells)
      : cells_(cells), box_(Lanes<D>::from(cells.grid().box(), HUGE_VAL)), removed_(cells.size()) {}

  std::uint32_t cell_of(const Real& position) const {
    return all<D>((position >= 0) & (position <= box_)) ? cells_.cell_of(position) : removed_;
  }

 private:
  InBox cells_;
  Real box_;
  std::uint32_t removed_;
};

/// Calls function(locator) with that of the cells, for flights of this kind.
template <class Flight, int D, class Function>
auto with_locator(const LatticeOfCells<D>& cells, Function function) {
  if (cells.is_grid()) return function(typename Flight::template Locator<CellLocator<D>>(cells));
  return function(typename Flight::template Locator<LatticeLocator<D>>(cells));
}

}  // namespace sandglass::motion
