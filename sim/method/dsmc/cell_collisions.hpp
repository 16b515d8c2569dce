#pragma once

#include "sim/method/dsmc/cell_stage.hpp"
#include "sim/method/dsmc/full_cells.hpp"

namespace sandglass::dsmc {

/// Counts of the collisions of whole cells since time zero.
struct CellCollisionCount {
  double collisions = 0;
  double heat = 0;       ///< energy that collisions took from the cells and gave back to their particles
  double heat_lost = 0;  ///< not given back: neither cell had particles that move against each other
};

/// Collisions between whole cells (Mueller 2001, 2.3.2 and Eqs. 2.20-2.33). A full cell of the colour that is active in
/// this step of the checkerboard collides with the neighbour that it approaches fastest, as two smooth particles with the
/// masses and mean velocities of the cells would, impact parameter drawn alike. The energy that restitution takes goes back
/// into the cells as heat: velocities relative to the mean grow by one factor. Momentum and energy of the pair are
/// unchanged to rounding.
///
/// The source lets several cells choose the same neighbour and does not say what becomes of it. Here the one that
/// approaches it fastest has it, the others wait: pairs then share no cell, and the books close.
template <int D>
class CellCollisions final : public CellStage<D> {
 public:
  CellCollisions(const Parameters& parameters, const LatticeOfCells<D>& cells, const FullCells<D>& full);

  CellNeeds needs(const CellStep<D>& step) override;
  void apply(const CellStep<D>& step) override;

  CellCollisionCount& count() { return count_; }
  std::size_t bytes() const {
    return choice_.capacity() * sizeof(Choice) + near_.capacity() +
           (active_.capacity() + chosen_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  /// Another cell, and how fast the two approach each other.
  struct Choice {
    double approach = 0;
    std::uint32_t cell = 0;
  };

  std::uint64_t turn(const CellStep<D>& step) const { return step.number * swap_; }
  void find_active(const CellStep<D>& step);
  void choose(const CellStep<D>& step);
  Choice fastest(const CellStep<D>& step, std::uint32_t cell) const;
  void collide(const CellStep<D>& step, std::uint32_t first, std::uint32_t second);

  const FullCells<D>& full_;
  double mass_, restitution_, heat_share_;
  std::uint64_t swap_;  ///< 1: the colours swap every step
  std::vector<std::uint32_t> active_,
      chosen_;                      ///< full cells of the active colour; cells that those have chosen
  std::vector<std::uint8_t> near_;  ///< by cell, not zero for an active one and its neighbours
  std::vector<Choice> choice_;      ///< by chosen cell: the one that has it
  CellCollisionCount count_;
};

extern template class CellCollisions<2>;
extern template class CellCollisions<3>;

}  // namespace sandglass::dsmc
