#pragma once

#include "sim/method/dsmc/cell_kernel.hpp"

namespace sandglass::dsmc {

/// Collisions by the clock of each cell (time counter, Bird 1976; Kawasaki 1986, 2.1): pairs are drawn with a probability in
/// proportion to relative speed times cross-section and collide one after the other; each sets the clock forward by the
/// time that a pair of its speed takes on average, until the clock passes the end of the step. What it is ahead by then
/// counts in the coming steps.
template <int D, class Rule>
class TimeCounterKernel final : public CellKernel<D, Rule, true> {
 public:
  explicit TimeCounterKernel(const Parameters& parameters) : CellKernel<D, Rule, true>(parameters) {}

  void collide(const CollisionStep<D>& step, std::uint32_t first_cell,
               std::uint32_t last_cell) const override {
    for (std::uint32_t cell = first_cell; cell < last_cell; ++cell)
      if (double& clock = step.clocks[cell]; --clock < 0) clock = collide_cell(step, cell, clock);
  }

 private:
  using CellKernel<D, Rule, true>::rule_;
  using typename CellKernel<D, Rule, true>::Cell;
  using typename CellKernel<D, Rule, true>::Candidate;

  /// `clock` is negative, in steps from the end of this one; returns where it stands then. Without a pair that could
  /// collide it is set to the end: time that nobody could use is not made up for.
  double collide_cell(const CollisionStep<D>& step, std::uint32_t number, double clock) const {
    const std::uint32_t begin = step.offsets[number], count = step.offsets[number + 1] - begin;
    if (count < 2) return 0;
    const double pairs = static_cast<double>(count) * (static_cast<double>(count) - 1);
    const double unit = step.coefficient * pairs * (step.factor == nullptr ? 1 : step.factor[number]);
    Random random(step.key, number);
    while (clock < 0) {
      VelocityBox<D> box(step.particles + begin, count);
      Cell cell = this->cell_at_work(step, number, box.square_diagonal());
      const double expected = unit * std::sqrt(cell.square_bound);
      if (!(expected > 0)) return 0;
      require_few(expected, count);
      clock = advance(step, cell, box, unit, clock, random);
      this->count(step, cell);
    }
    return clock;
  }

  /// Until the clock has passed the end, or 64 times as many candidates in a row are refused as there are pairs: the cell has
  /// cooled, and the bound must be looked up again.
  [[gnu::always_inline]] double advance(const CollisionStep<D>& step, Cell& cell, VelocityBox<D>& box,
                                        double unit, double clock, Random& random) const {
    const std::uint64_t patience = std::uint64_t{64} * cell.count * (cell.count - 1);
    double square_diagonal = box.square_diagonal();
    for (std::uint64_t refused = 0; clock < 0 && refused < patience; ++refused) {
      Candidate candidate;
      if (!this->collides(cell, random, candidate)) continue;
      refused = 0;
      clock += 1 / (unit * rule_.rate(cell.columns, candidate.pair, std::sqrt(candidate.square_speed)));
      if (const double ratio = this->widen(cell, candidate.pair, box, square_diagonal); ratio > 1) {
        cell.square_bound *= ratio;
        require_few(unit * std::sqrt(cell.square_bound), cell.count);
        ++*step.bound_raised;
      }
    }
    return clock;
  }
};

}  // namespace sandglass::dsmc
