#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/policies.hpp"
#include "sim/space/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sandglass::dsmc {

/// Smallest box in velocity space around the velocities of a cell. Its diagonal bounds every relative speed, and its
/// edges are cheap to keep as collisions change the velocities: no pair is ever above the bound.
template <int D>
class VelocityBox {
 public:
  using Lane = Lanes<D>;
  using Real = typename Lane::Real;

  VelocityBox() = default;
  /// Eight particles at a time, the last one again where there are fewer: a loop whose end can be guessed.
  VelocityBox(const Phase<D>* particles, std::uint32_t count) : low_(velocity_of(particles[0])), high_(low_) {
    const std::uint32_t last = std::max(count, 1u) - 1;
    for (std::uint32_t i = 0; i <= last; i += 8)
      for (std::uint32_t lane = 0; lane < 8; ++lane)
        include(velocity_of(particles[std::min(i + lane, last)]));
  }
  void include(const Real& velocity) {
    low_ = velocity < low_ ? velocity : low_;
    high_ = velocity > high_ ? velocity : high_;
  }
  double square_diagonal() const {
    const Real edge = high_ - low_;
    const Real square = edge * edge;
    double sum = square[0] + square[1];
    if constexpr (D == 3) sum += square[2];
    return sum;
  }

 private:
  static Real velocity_of(const Phase<D>& particle) { return Lane::load(particle.position.data() + D); }

  Real low_, high_;
};

inline double square(double x) { return x * x; }

struct Pair {
  std::uint32_t first, second;
};

/// Two different particles of `count`, each ordered pair alike; 32 bits each (bias below count / 2^32).
inline Pair draw_pair(std::uint32_t count, Random& random) {
  const std::uint64_t bits = random.bits();
  const auto first = static_cast<std::uint32_t>(
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits)) * count) >> 32);
  const auto other = static_cast<std::uint32_t>(((bits >> 32) * (count - 1)) >> 32);
  return {first, other + (other >= first)};
}

/// Majorant collisions (no time counter, Bird 1989) of one step in each cell.
template <int D, class Selection, class Displacement, bool Factor, bool Transfer>
class CollisionKernel final : public CollisionStage<D> {
 public:
  explicit CollisionKernel(const Parameters& parameters)
      : selection_(parameters), displacement_(parameters.offset), mass_(parameters.mass) {}

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
  std::size_t prepare(const CollisionStep<D>& step, std::uint32_t first, std::uint32_t last,
                      Task* tasks) const {
    std::size_t count = 0;
    for (std::uint32_t cell = first; cell < last; ++cell) {
      const std::uint32_t begin = step.offsets[cell], particles = step.offsets[cell + 1] - begin;
      if (particles < 2) continue;  // behind the last particle there is no velocity
      Task& task = tasks[count];
      task.box = VelocityBox<D>(step.particles + begin, particles);
      task.square_diagonal = task.box.square_diagonal();
      task.random = Random(step.key, cell);
      const double pairs = static_cast<double>(particles) * (static_cast<double>(particles) - 1);
      double expected = step.coefficient * pairs * selection_.bound(std::sqrt(task.square_diagonal));
      if constexpr (Factor) expected *= step.factor[cell];
      task.candidates = selection_.whole(expected, task.random);
      task.cell = cell;
      count += task.candidates > 0;
    }
    return count;
  }

  void collide_cell(const CollisionStep<D>& step, Task& task) const {
    const std::uint32_t begin = step.offsets[task.cell], count = step.offsets[task.cell + 1] - begin;
    Phase<D>* particles = step.particles + begin;
    Random random = task.random;  // in registers
    double square_bound = square(selection_.bound(1)) * task.square_diagonal;
    double transfer = 0;
    for (std::uint64_t left = task.candidates; left > 0; --left) {
      ++step.tally->candidates;
      const Pair pair = draw_pair(count, random);
      Phase<D>& one = particles[pair.first];
      Phase<D>& two = particles[pair.second];
      const Vector<D> relative = one.velocity - two.velocity;
      const double square_speed = relative.squaredNorm();
      if (!selection_.accepts(square_speed, square_bound, random.uniform())) continue;
      transfer += collide_pair(one, two, relative, square_speed, random);
      ++step.tally->collisions;
      if (left == 1) break;
      if (const double ratio = widen(task, one.velocity, two.velocity); ratio > 1) {
        // The rest of the step goes on with the higher bound and proportionally more candidates.
        left = 1 + selection_.whole((static_cast<double>(left) - 1) * std::sqrt(ratio), random);
        square_bound *= ratio;
        ++*step.bound_raised;
      }
    }
    if constexpr (Transfer) step.tally->transfer.add(transfer);
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

  /// Returns the momentum times distance that the offset carries.
  double collide_pair(Phase<D>& one, Phase<D>& two, const Vector<D>& relative, double square_speed,
                      Random& random) const {
    const Vector<D> change =
        selection_.template kick<D>(one.velocity, two.velocity, relative, square_speed, random);
    if constexpr (Displacement::moves) {
      const Vector<D> displacement = displacement_.template displacement<D>(change.normalized(), random);
      one.position += displacement;
      two.position -= displacement;
      if constexpr (Transfer) return mass_ * (one.velocity - two.velocity).dot(displacement);
    }
    return 0;
  }

  Selection selection_;
  Displacement displacement_;
  double mass_;
};

template <int D, class Selection, class Displacement>
std::unique_ptr<CollisionStage<D>> make_kernel(const Parameters& parameters) {
  const bool factor = parameters.factor.formula != nullptr;
  if constexpr (Displacement::moves) {
    if (parameters.measure_transfer) {
      if (factor)
        return std::make_unique<CollisionKernel<D, Selection, Displacement, true, true>>(parameters);
      return std::make_unique<CollisionKernel<D, Selection, Displacement, false, true>>(parameters);
    }
  }
  if (factor) return std::make_unique<CollisionKernel<D, Selection, Displacement, true, false>>(parameters);
  return std::make_unique<CollisionKernel<D, Selection, Displacement, false, false>>(parameters);
}

template <int D, class Selection>
std::unique_ptr<CollisionStage<D>> choose_kernel(const Parameters& parameters) {
  if (parameters.offset.random != 0) return make_kernel<D, Selection, RandomOffset>(parameters);
  if (parameters.offset.consistent != 0) return make_kernel<D, Selection, ConsistentOffset>(parameters);
  return make_kernel<D, Selection, NoOffset>(parameters);
}

}  // namespace sandglass::dsmc
