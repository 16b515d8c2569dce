#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/displacement.hpp"
#include "sim/method/dsmc/velocity_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sandglass::dsmc {

inline double square(double x) { return x * x; }

/// Two different particles of `count`, each ordered pair alike; 32 bits each (bias below count / 2^32).
inline Pair draw_pair(std::uint32_t count, Random& random) {
  const std::uint64_t bits = random.bits();
  const auto first = static_cast<std::uint32_t>(
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits)) * count) >> 32);
  const auto other = static_cast<std::uint32_t>(((bits >> 32) * (count - 1)) >> 32);
  return {first, other + (other >= first)};
}

/// Majorant collisions (no time counter, Bird 1989) of one step in each cell. `Rule` is a pair rule, see SmoothPairs;
/// `Displaces`: partners are displaced.
template <int D, class Rule, bool Displaces>
class CollisionKernel final : public CollisionStage<D> {
 public:
  explicit CollisionKernel(const Parameters& parameters)
      : rule_(parameters),
        offset_(parameters.offset),
        measure_transfer_(parameters.measure_transfer && Displaces) {}

  void collide(const CollisionStep<D>& step, std::uint32_t first_cell,
               std::uint32_t last_cell) const override {
    std::array<Task, kBatch> tasks;
    for (std::uint32_t first = first_cell; first < last_cell; first += kBatch) {
      const std::size_t count = prepare(step, first, std::min(first + kBatch, last_cell), tasks.data());
      for (std::size_t i = 0; i < count; ++i) collide_cell(step, tasks[i]);
    }
  }

 private:
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
                        rule_.bound(rule_.columns(step, begin), particles, std::sqrt(task.square_diagonal));
      if (step.factor != nullptr) expected *= step.factor[cell];
      require_few(expected, particles);
      task.candidates = rule_.whole(expected, task.random);
      task.cell = cell;
      count += task.candidates > 0;
    }
    return count;
  }

  [[gnu::always_inline]] void collide_cell(const CollisionStep<D>& step, Task& task) const {
    const std::uint32_t begin = step.offsets[task.cell], count = step.offsets[task.cell + 1] - begin;
    const typename Rule::Columns columns = rule_.columns(step, begin);
    Random random = task.random;  // in registers
    double square_bound = square(rule_.bound(columns, count, 1)) * task.square_diagonal;
    const bool displaces = Displaces && (step.still == nullptr || step.still[task.cell] == 0);
    double transfer = 0;
    for (std::uint64_t left = task.candidates; left > 0; --left) {
      ++step.tally->candidates;
      const Pair pair = draw_pair(count, random);
      Phase<D>& one = columns.phases[pair.first];
      Phase<D>& two = columns.phases[pair.second];
      const Vector<D> relative = one.velocity - two.velocity;
      const double square_speed = relative.squaredNorm();
      if (!rule_.accepts(columns, pair, square_speed, square_bound, random.uniform())) continue;
      const Vector<D> change = rule_.collide(columns, pair, relative, square_speed, random);
      if (displaces) transfer += displace(columns, pair, change, one, two, random);
      ++step.tally->collisions;
      if (left == 1) break;
      if (const double ratio = widen(task, one.velocity, two.velocity); ratio > 1) {
        // The rest of the step goes on with the higher bound and proportionally more candidates.
        const double rest = (static_cast<double>(left) - 1) * std::sqrt(ratio);
        require_few(rest, count);  // collisions that heat would never come to an end
        left = 1 + rule_.whole(rest, random);
        square_bound *= ratio;
        ++*step.bound_raised;
      }
    }
    if (measure_transfer_) step.tally->transfer.add(transfer);
  }

  /// Takes the velocities after a collision into the box and returns by how much its square diagonal grew.
  double widen(Task& task, const Vector<D>& velocity_1, const Vector<D>& velocity_2) const {
    // From registers: a load of what was just stored in pieces would wait for the stores.
    task.box.include(Lanes<D>::from(velocity_1, 0));
    task.box.include(Lanes<D>::from(velocity_2, 0));
    const double before = task.square_diagonal;
    task.square_diagonal = task.box.square_diagonal();
    return task.square_diagonal > before ? task.square_diagonal / before : 1;
  }

  /// Moves the partners apart along the momentum change and returns the momentum times distance that this carries.
  [[gnu::always_inline]] double displace(const typename Rule::Columns& columns, const Pair& pair,
                                         const Vector<D>& change, Phase<D>& one, Phase<D>& two,
                                         Random& random) const {
    const Vector<D> shift = displacement<D>(offset_, change.normalized(), random);
    one.position += shift;
    two.position -= shift;
    return measure_transfer_ ? rule_.transfer(columns, pair, shift) : 0;
  }

  Rule rule_;
  Offset offset_;
  bool measure_transfer_;
};

template <int D, class Rule>
std::unique_ptr<CollisionStage<D>> make_kernel(const Parameters& parameters) {
  if (parameters.offset.any()) return std::make_unique<CollisionKernel<D, Rule, true>>(parameters);
  return std::make_unique<CollisionKernel<D, Rule, false>>(parameters);
}

}  // namespace sandglass::dsmc
