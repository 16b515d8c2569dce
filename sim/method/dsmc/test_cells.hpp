#pragma once

#include "sim/method/dsmc/collision_stage.hpp"

#include <vector>

namespace sandglass::dsmc {

/// Particles in cells for tests of the collision stage alone: nothing moves them and nothing sorts them.
template <int D>
struct TestCells {
  Column<Phase<D>> particles;
  std::vector<std::uint32_t> offsets{0};
  std::vector<std::uint8_t> species;  ///< empty: one
  std::vector<Spin<D>> spins;         ///< empty: smooth
  std::vector<double> contact;        ///< empty: none
  std::vector<double> clocks;         ///< empty: none
  Tally tally;
  std::uint64_t bound_raised = 0;

  std::uint32_t size() const { return static_cast<std::uint32_t>(offsets.size() - 1); }
  void add_cell(const std::vector<Vector<D>>& velocities) {
    for (const Vector<D>& velocity : velocities) particles.push_back({Vector<D>::Zero(), velocity});
    offsets.push_back(static_cast<std::uint32_t>(particles.size()));
  }
  /// `coefficient` as of CollisionStep; `number` is the step that names the streams.
  CollisionStep<D> step(double coefficient, std::uint64_t number, const double* factor = nullptr) {
    return {StreamKey(1, Purpose::collisions, 0, number),
            coefficient,
            factor,
            nullptr,
            0,
            particles.data(),
            offsets.data(),
            &tally,
            &bound_raised,
            species.empty() ? nullptr : species.data(),
            spins.empty() ? nullptr : spins.data(),
            contact.empty() ? nullptr : contact.data(),
            clocks.empty() ? nullptr : clocks.data()};
  }
  void collide(const CollisionStage<D>& stage, double coefficient, std::uint64_t number) {
    stage.collide(step(coefficient, number), 0, size());
  }
};

template <int D>
std::vector<Vector<D>> random_velocities(std::size_t count, std::uint64_t index) {
  Random random(StreamKey(1, Purpose::velocities, 0, 0), index);
  std::vector<Vector<D>> velocities(count);
  for (Vector<D>& velocity : velocities)
    for (int axis = 0; axis < D; ++axis) velocity[axis] = 2 * random.uniform() - 1;
  return velocities;
}

/// Candidates of a cell per unit of CollisionStep::coefficient: ordered pairs times the diagonal of the velocity box.
template <int D>
double candidates_per_coefficient(const std::vector<Vector<D>>& velocities) {
  Vector<D> low = velocities.front(), high = low;
  for (const Vector<D>& velocity : velocities) {
    low = low.cwiseMin(velocity);
    high = high.cwiseMax(velocity);
  }
  const auto count = static_cast<double>(velocities.size());
  return count * (count - 1) * (high - low).norm();
}

/// Sum over unordered pairs of a function of the relative speed.
template <int D, class Function>
double sum_pairs(const std::vector<Vector<D>>& velocities, Function function) {
  double sum = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) sum += function((velocities[i] - velocities[j]).norm());
  return sum;
}

/// Collisions of particles that pass through each other: the rate stays what it is, however many there are.
inline Parameters transparent() {
  Parameters parameters;
  parameters.restitution = -1;
  return parameters;
}

/// Collisions of one cell in each of `streams` independent steps.
template <int D>
std::vector<double> count_collisions(const CollisionStage<D>& stage, const std::vector<Vector<D>>& velocities,
                                     double coefficient, std::uint64_t streams) {
  std::vector<double> counts;
  TestCells<D> cells;
  cells.add_cell(velocities);
  const auto fresh = cells.particles;
  for (std::uint64_t stream = 0; stream < streams; ++stream) {
    cells.particles = fresh;
    const std::uint64_t before = cells.tally.collisions;
    cells.collide(stage, coefficient, stream);
    counts.push_back(static_cast<double>(cells.tally.collisions - before));
  }
  return counts;
}

}  // namespace sandglass::dsmc
