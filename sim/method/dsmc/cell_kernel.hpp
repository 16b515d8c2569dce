#pragma once

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/displacement.hpp"
#include "sim/method/dsmc/velocity_box.hpp"

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

/// What a candidate is and what becomes of it, whatever says how many there are. `Rule` is a pair rule, see SmoothPairs;
/// `Displaces`: partners may be displaced.
template <int D, class Rule, bool Displaces>
class CellKernel : public CollisionStage<D> {
 protected:
  explicit CellKernel(const Parameters& parameters)
      : rule_(parameters),
        offset_(parameters.offset),
        displaces_(Displaces && offset_.any()),
        measure_transfer_(parameters.measure_transfer && displaces_) {}

  /// A cell at work.
  struct Cell {
    typename Rule::Columns columns;
    std::uint32_t count;
    double square_bound;
    bool displaces;
    std::uint64_t candidates = 0, collisions = 0;
    double transfer = 0;
  };
  struct Candidate {
    Pair pair;
    double square_speed;
  };

  [[gnu::always_inline]] Cell cell_at_work(const CollisionStep<D>& step, std::uint32_t cell,
                                           double square_diagonal) const {
    const std::uint32_t count = step.offsets[cell + 1] - step.offsets[cell];
    const typename Rule::Columns columns = rule_.columns(step, cell);
    return {columns, count, square(rule_.bound(columns, count, 1)) * square_diagonal,
            displaces_ && (step.still == nullptr || step.still[cell] == 0)};
  }

  /// Draws a candidate, and collides and displaces it where the rule accepts it.
  [[gnu::always_inline]] bool collides(Cell& cell, Random& random, Candidate& candidate) const {
    ++cell.candidates;
    const Pair pair = draw_pair(cell.count, random);
    const Vector<D> relative =
        cell.columns.phases[pair.first].velocity - cell.columns.phases[pair.second].velocity;
    const double square_speed = relative.squaredNorm();
    candidate = {pair, square_speed};
    if (!rule_.accepts(cell.columns, pair, square_speed, cell.square_bound, random.uniform())) return false;
    const Vector<D> change = rule_.collide(cell.columns, pair, relative, square_speed, random);
    if constexpr (Displaces)
      if (cell.displaces) displace(cell, pair, change, random);
    ++cell.collisions;
    return true;
  }

  /// Takes the velocities after a collision into the box and returns by how much its square diagonal grew.
  [[gnu::always_inline]] double widen(const Cell& cell, const Pair& pair, VelocityBox<D>& box,
                                      double& square_diagonal) const {
    // From registers: a load of what was just stored in pieces would wait for the stores.
    box.include(Lanes<D>::from(cell.columns.phases[pair.first].velocity, 0));
    box.include(Lanes<D>::from(cell.columns.phases[pair.second].velocity, 0));
    const double before = square_diagonal;
    square_diagonal = box.square_diagonal();
    return square_diagonal > before ? square_diagonal / before : 1;
  }

  /// What the cell counted in registers.
  [[gnu::always_inline]] void count(const CollisionStep<D>& step, const Cell& cell) const {
    step.tally->candidates += cell.candidates;
    step.tally->collisions += cell.collisions;
    if constexpr (Displaces)
      if (measure_transfer_) step.tally->transfer.add(cell.transfer);
  }

  Rule rule_;

 private:
  /// Moves the partners apart along the momentum change; sums the momentum times distance that this carries.
  [[gnu::always_inline]] void displace(Cell& cell, const Pair& pair, const Vector<D>& change,
                                       Random& random) const {
    const Vector<D> shift = displacement<D>(offset_, change.normalized(), random);
    rule_.displace(cell.columns, pair, shift);
    if (measure_transfer_) [[unlikely]]
      cell.transfer += rule_.transfer(cell.columns, pair, shift);
  }

  Offset offset_;
  bool displaces_, measure_transfer_;
};

}  // namespace sandglass::dsmc
