#pragma once

#include <cmath>

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/policies.hpp"

namespace sandglass::dsmc {

/// Smallest box in velocity space around the velocities of a cell. Its diagonal bounds every relative speed, and its
/// edges are cheap to keep as collisions change the velocities: no pair is ever above the bound.
template <int D>
class VelocityBox {
 public:
  VelocityBox(const Phase<D>* first, const Phase<D>* last) : low_(first->velocity), high_(first->velocity) {
    for (const Phase<D>* particle = first + 1; particle < last; ++particle) include(particle->velocity);
  }
  void include(const Vector<D>& velocity) {
    low_ = low_.cwiseMin(velocity);
    high_ = high_.cwiseMax(velocity);
  }
  double square_diagonal() const { return (high_ - low_).squaredNorm(); }

 private:
  Vector<D> low_, high_;
};

struct Pair {
  std::uint32_t first, second;
};

/// Two different particles of `count`, each ordered pair alike; 32 bits each (bias below count / 2^32).
inline Pair draw_pair(std::uint32_t count, Random& random) {
  const std::uint64_t bits = random.bits();
  const auto first = static_cast<std::uint32_t>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(bits)) * count) >> 32);
  const auto other = static_cast<std::uint32_t>(((bits >> 32) * (count - 1)) >> 32);
  return {first, other + (other >= first)};
}

/// Majorant collisions (no time counter, Bird 1989) of one step in each cell.
template <int D, class Selection, class Displacement, bool Factor, bool Transfer>
class CollisionKernel final : public CollisionStage<D> {
 public:
  explicit CollisionKernel(const Parameters& parameters)
      : selection_(parameters), displacement_(parameters.offset), mass_(parameters.mass) {}

  void collide(const CollisionStep<D>& step, std::uint32_t first_cell, std::uint32_t last_cell) const override {
    for (std::uint32_t cell = first_cell; cell < last_cell; ++cell) {
      const std::uint32_t begin = step.offsets[cell], end = step.offsets[cell + 1];
      if (end - begin > 1) collide_cell(step, cell, step.particles + begin, end - begin);
    }
  }

 private:
  void collide_cell(const CollisionStep<D>& step, std::uint32_t cell, Phase<D>* particles, std::uint32_t count) const {
    Random random(step.key, cell);
    VelocityBox<D> box(particles, particles + count);
    double diagonal = box.square_diagonal();
    double square_bound = selection_.bound(1) * selection_.bound(1) * diagonal;
    double expected = step.coefficient * count * (count - 1.0) * std::sqrt(square_bound);
    if constexpr (Factor) expected *= step.factor[cell];
    double transfer = 0;
    for (std::uint64_t left = selection_.whole(expected, random); left > 0; --left) {
      ++step.tally->candidates;
      const Pair pair = draw_pair(count, random);
      Phase<D>& one = particles[pair.first];
      Phase<D>& two = particles[pair.second];
      const Vector<D> relative = one.velocity - two.velocity;
      const double square_speed = relative.squaredNorm();
      if (!selection_.accepts(square_speed, square_bound, random.uniform())) continue;
      if (square_speed == 0) continue;
      transfer += collide_pair(one, two, relative, square_speed, random);
      ++step.tally->collisions;
      box.include(one.velocity);
      box.include(two.velocity);
      if (const double wider = box.square_diagonal(); wider > diagonal) {
        // The rest of the step goes on with the higher bound and proportionally more candidates.
        left = 1 + selection_.whole((static_cast<double>(left) - 1) * std::sqrt(wider / diagonal), random);
        square_bound *= wider / diagonal;
        diagonal = wider;
        ++step.tally->bound_raised;
      }
    }
    if constexpr (Transfer) step.tally->transfer.add(transfer);
  }

  /// Returns the momentum times distance that the offset carries.
  double collide_pair(Phase<D>& one, Phase<D>& two, const Vector<D>& relative, double square_speed, Random& random) const {
    const Vector<D> normal =
        contact_normal(relative, 1 / std::sqrt(square_speed), selection_.template impact<D>(random));
    selection_.template kick<D>(one.velocity, two.velocity, normal);
    if constexpr (Displacement::moves) {
      const Vector<D> displacement = displacement_.template displacement<D>(normal, random);
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
      if (factor) return std::make_unique<CollisionKernel<D, Selection, Displacement, true, true>>(parameters);
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
