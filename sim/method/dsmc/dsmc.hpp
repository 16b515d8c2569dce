#pragma once

#include "sim/method/cell_simulator.hpp"
#include "sim/method/dsmc/cell_clocks.hpp"
#include "sim/method/dsmc/cell_stage.hpp"
#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/contact_partners.hpp"
#include "sim/method/dsmc/excluded_volume.hpp"
#include "sim/method/dsmc/pair_factor.hpp"

#include <memory>
#include <optional>

namespace sandglass::dsmc {

/// Direct simulation Monte Carlo and its dense-gas variants in D dimensions. A step works on whole cells where a
/// stage asks for it, collides the particles of each cell (with partners at contact: of neighbouring ones too), moves them,
/// and sorts them into the cells where they arrive. With an excluded volume of cells, moves into full ones are refused.
/// Where cells are displaced from step to step, the particles stand between two steps in the cells of the coming one.
template <int D>
class Dsmc final : public CellSimulator<D> {
 public:
  /// `purpose` names the streams of the collisions; of `columns` (docs/particle-columns.md) only those exist that are named.
  Dsmc(const LatticeOfCells<D>& cells, const Parameters& parameters,
       const motion::MotionParameters<D>& motion, const Streams& streams,
       Purpose purpose = Purpose::collisions, const std::vector<ColumnInfo>& columns = {});

  /// A stage on whole cells at the start of every step, after those added before.
  void add(std::unique_ptr<CellStage<D>> stage) { stages_.add(std::move(stage)); }

  void assign(const Particles<D>& particles) override;
  void step(double dt, std::uint64_t step) override;
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  void restore(const Particles<D>& particles, const Memory& memory) override;
  std::size_t bytes() const override;

 private:
  std::vector<std::uint64_t*> counts() override;

  using CellSimulator<D>::streams_, CellSimulator<D>::store_, CellSimulator<D>::tally_;

  void take_in(const Particles<D>& particles);
  void make_factor(double particles);
  Vector<D> drawn_shift(std::uint64_t step) const;
  void shift_cells(const Vector<D>& part);
  /// Displaces the cells; the particles arrive in those of the next step.
  void find_cells_of(std::uint64_t next_step);
  double impact_coefficient() const;
  const std::uint8_t* species();  ///< of each particle; null where there is one only
  const double* factor() const;   ///< as of CollisionStep
  CollisionStep<D> collision_step(double dt, const StreamKey& key);
  void move(const motion::MotionStep& motion);
  /// Collides the cells and calls move(first cell, last cell) block by block.
  template <class Move>
  void collide_and(const CollisionStep<D>& collisions, Move move);
  void collide_and_enter(const motion::MotionStep& motion, const CollisionStep<D>& collisions,
                         const StreamKey& key);
  void collide_and_move(const motion::MotionStep& motion, const CollisionStep<D>& collisions);

  Parameters parameters_;
  Purpose purpose_;
  std::unique_ptr<CollisionStage<D>> collisions_;
  std::unique_ptr<ContactPartners<D>> contact_;  ///< instead of collisions_; null where partners share a cell
  std::optional<PairFactor<D>> factor_;
  std::optional<CellClocks> clocks_;
  std::vector<double> relative_weights_;  ///< of each cell over that of the method; empty: all 1
  double assigned_ = 0;                   ///< particles that the window of the pair factor was chosen for
  CellStages<D> stages_;
  std::unique_ptr<ExcludedVolumeOfCells<D>> excluded_;  ///< null where particles are points
  std::uint64_t bound_raised_ = 0;
};

extern template class Dsmc<2>;
extern template class Dsmc<3>;

}  // namespace sandglass::dsmc
