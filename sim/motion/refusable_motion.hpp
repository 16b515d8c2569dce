#pragma once

#include "sim/motion/motion_stage.hpp"

#include <span>
#include <vector>

namespace sandglass::motion {

/// The moves of one step before they happen. Particles stand in the order (old cell, old place).
template <int D>
struct Proposals {
  const LatticeOfCells<D>& cells;
  std::span<const std::uint32_t> offsets;  ///< first particle of each cell, one more entry than cells
  std::span<const std::uint32_t>
      targets;  ///< cell where each particle would arrive; the number of cells: it would leave
  std::span<const std::uint32_t> entering;  ///< per cell: particles that would come from other cells
  std::span<std::uint8_t>
      refused;  ///< per particle, false at first: the rule's to set; who would leave is not refused
};

/// Which moves of a step are refused. What it decides for a particle may depend on the proposals and on (old cell, old
/// place), which name a random stream (stream_index.hpp), and on nothing else: no order of work, no earlier draw.
template <int D>
class EntryRule {
 public:
  virtual ~EntryRule() = default;
  virtual void decide(const Proposals<D>& proposals) = 0;
};

/// Free flight with moves that a rule may refuse: all are proposed, the rule decides, the accepted ones happen. A refused
/// particle keeps place, velocity and cell, and gets no gravity. A place that an offset has taken out of the cell is moved
/// back to its edge.
template <int D>
class RefusableMotion {
 public:
  RefusableMotion(const MotionParameters<D>& parameters, const Vector<D>& box)
      : stage_(make_refusable_stage<D>(parameters, box)) {}

  /// Advances all particles and counts them into the cells where they arrive; the store is then to be sorted.
  void advance(ParticleStore<D>& store, const MotionStep& step, EntryRule<D>& rule);

  std::size_t bytes() const {
    return (targets_.capacity() + entering_.capacity()) * sizeof(std::uint32_t) +
           arrived_.capacity() * sizeof(Phase<D>) + refused_.capacity();
  }

 private:
  void count_entering(std::span<const std::uint32_t> offsets);
  void let_go(std::uint32_t removed);
  void take_places(ParticleStore<D>& store) const;

  std::unique_ptr<RefusableStage<D>> stage_;
  std::vector<std::uint32_t> targets_, entering_;
  std::vector<Phase<D>> arrived_;
  std::vector<std::uint8_t> refused_;
};

extern template class RefusableMotion<2>;
extern template class RefusableMotion<3>;

}  // namespace sandglass::motion
