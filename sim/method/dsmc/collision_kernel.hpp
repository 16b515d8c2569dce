#pragma once

#include "sim/method/dsmc/cell_kernel.hpp"

#include <algorithm>
#include <array>

namespace sandglass::dsmc {

/// Majorant collisions (no time counter, Bird 1989) of one step in each cell.
template <int D, class Rule, bool Displaces>
class CollisionKernel final : public CellKernel<D, Rule, Displaces> {
 public:
  explicit CollisionKernel(const Parameters& parameters) : CellKernel<D, Rule, Displaces>(parameters) {}

  void collide(const CollisionStep<D>& step, std::uint32_t first_cell,
               std::uint32_t last_cell) const override {
    std::array<Task, kBatch> tasks;
    for (std::uint32_t first = first_cell; first < last_cell; first += kBatch) {
      const std::size_t count = prepare(step, first, std::min(first + kBatch, last_cell), tasks.data());
      for (std::size_t i = 0; i < count; ++i) collide_cell(step, tasks[i]);
    }
  }

 private:
  using CellKernel<D, Rule, Displaces>::rule_;
  using typename CellKernel<D, Rule, Displaces>::Cell;
  using typename CellKernel<D, Rule, Displaces>::Candidate;

  static constexpr std::uint32_t kBatch = 64;

  /// A cell with candidates.
  struct Task {
    VelocityBox<D> box;
    double square_diagonal;
    Random random;
    std::uint64_t candidates;
    std::uint32_t cell;
  };

  /// Draws the number of candidates of each cell. Apart from the collisions, whose branches nobody can guess, since the
  /// long chain from velocities to the number then overlaps from cell to cell.
  [[gnu::always_inline]] std::size_t prepare(const CollisionStep<D>& step, std::uint32_t first,
                                             std::uint32_t last, Task* tasks) const {
    std::size_t count = 0;
    for (std::uint32_t cell = first; cell < last; ++cell) {
      const std::uint32_t begin = step.offsets[cell], particles = step.offsets[cell + 1] - begin;
      if (particles < 2) continue;  // behind the last particle there is no velocity
      Task& task = tasks[count];
      task.box = VelocityBox<D>(step.particles + begin, particles);
      task.square_diagonal = task.box.square_diagonal();
      task.random = Random(step.key, cell);
      const double pairs = static_cast<double>(particles) * (static_cast<double>(particles) - 1);
      double expected = step.coefficient * pairs *
                        rule_.bound(rule_.columns(step, cell), particles, std::sqrt(task.square_diagonal));
      if (step.factor != nullptr) expected *= step.factor[cell];
      require_few(expected, particles);
      task.candidates = rule_.whole(expected, task.random);
      task.cell = cell;
      count += task.candidates > 0;
    }
    return count;
  }

  [[gnu::always_inline]] void collide_cell(const CollisionStep<D>& step, Task& task) const {
    Cell cell = this->cell_at_work(step, task.cell, task.square_diagonal);
    Random random = task.random;  // in registers
    for (std::uint64_t left = task.candidates; left > 0; --left) {
      Candidate candidate;
      if (!this->collides(cell, random, candidate)) continue;
      if (left == 1) break;
      if (const double ratio = this->widen(cell, candidate.pair, task.box, task.square_diagonal); ratio > 1) {
        // The rest of the step goes on with the higher bound and proportionally more candidates.
        const double rest = (static_cast<double>(left) - 1) * std::sqrt(ratio);
        require_few(rest, cell.count);  // collisions that heat would never come to an end
        left = 1 + rule_.whole(rest, random);
        cell.square_bound *= ratio;
        ++*step.bound_raised;
      }
    }
    this->count(step, cell);
  }
};

}  // namespace sandglass::dsmc
