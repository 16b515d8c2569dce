#pragma once

#include "sim/method/cloner.hpp"
#include "sim/method/counts_of_ranks.hpp"
#include "sim/method/simulator.hpp"
#include "sim/motion/entrance.hpp"
#include "sim/motion/motion_stage.hpp"
#include "sim/space/shared_store.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace sandglass {

/// What methods share whose particles stand in cells and fly freely within a step: store, flight, counts and restart.
/// A method of this kind says what happens in a step.
template <int D>
class CellSimulator : public Simulator<D> {
 public:
  /// `traits` of each species; of `columns` (docs/particle-columns.md) only those exist that are named.
  CellSimulator(const LatticeOfCells<D>& cells, std::vector<SpeciesTraits> traits, double weight,
                const motion::MotionParameters<D>& motion, const Streams& streams,
                const std::vector<ColumnInfo>& columns);

  void share(Communicator& ranks) override;
  void assign(const Particles<D>& particles) override;
  View<D> view() override;
  View<D> view_of_all() override;
  void gather_counts() override;
  std::span<const std::uint64_t> ids() const override { return store_.ids(); }
  std::uint64_t size() const override { return store_.size(); }
  void insert(const Particles<D>& particles) override;
  void enter(const Entrants<D>& entrants, double dt, std::uint64_t step) override;
  void remove(std::span<const std::uint32_t> places) override;
  Tally& tally() override { return tally_; }
  /// Those who have left by open sides, and copies between regions; nothing in a box without.
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  void clear_counts() override;
  std::size_t bytes() const override {
    return store_.bytes() + (cloner_ ? cloner_->bytes() : 0) + (shared_ ? shared_->bytes() : 0);
  }

 protected:
  /// The coming step, for the flight.
  motion::MotionStep motion_step(double dt, std::uint64_t step) const {
    return {dt, time_, StreamKey(streams_.seed, Purpose::walls, streams_.replica, step)};
  }
  void fly(std::size_t first, std::size_t last, const motion::MotionStep& step) {
    motion_->advance(store_, first, last, step);
  }
  /// Sorts the particles into the cells where they arrived.
  void end_step(double dt, std::uint64_t step);
  /// Every particle gets the weight of its cell, see Cloner. There is a column of weights.
  void weigh_by_cell(std::vector<double> weights, const CloningFaults& faults) {
    cloner_.emplace(std::move(weights), faults, tally_);
  }
  std::array<bool, D> periodic() const;
  /// The cells that a step works on; fills in the numbers by cell that are worked out elsewhere.
  const SharedCells& work() const { return shared_ ? shared_->work() : all_cells_; }
  /// What a method counts since time zero, beside the tally.
  virtual std::vector<std::uint64_t*> counts();

  Streams streams_;
  ParticleStore<D> store_;
  Tally tally_;

 private:
  StreamKey cloning_key(std::uint64_t step) const {
    return {streams_.seed, Purpose::cloning, streams_.replica, step};
  }
  View<D> view_of(const ParticleStore<D>& store);
  CountsOfRanks<D> all_counts() {
    return {tally_, counts(), motion_parameters_.planes, motion_parameters_.impulses};
  }
  void count_those_who_leave();
  void count_one_who_leaves(const Vector<D>& position);

  SharedCells all_cells_;
  std::vector<ColumnInfo> columns_;
  std::unique_ptr<SharedStore<D>> shared_;      ///< null: all particles are here
  const ParticleStore<D>* gathered_ = nullptr;  ///< all particles, since the last step
  std::vector<SpeciesTraits> traits_;           ///< of each species
  double weight_;
  motion::MotionParameters<D> motion_parameters_;
  std::unique_ptr<motion::MotionStage<D>> motion_;
  std::unique_ptr<motion::Entrance<D>> entrance_;  ///< since the first enter()
  std::optional<Cloner<D>> cloner_;                ///< without regions none
  double time_ = 0;                                ///< since assign(): moving walls ask
  std::array<std::array<std::uint64_t, 2>, D>
      left_{};  ///< since assign(), by axis: over the low, the high side
};

extern template class CellSimulator<2>;
extern template class CellSimulator<3>;

}  // namespace sandglass
