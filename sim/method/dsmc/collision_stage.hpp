#pragma once

#include "sim/base/random.hpp"
#include "sim/method/dsmc/parameters.hpp"
#include "sim/observe/tally.hpp"
#include "sim/space/particle_store.hpp"

#include <cstdint>
#include <memory>

namespace sandglass::dsmc {

/// Two particles, by their places in their cell.
struct Pair {
  std::uint32_t first, second;
};

[[noreturn]] void refuse_candidates(double candidates, std::uint32_t particles);

/// What changes from step to step.
template <int D>
struct CollisionStep {
  StreamKey key;
  double
      coefficient;  ///< weight sigma dt / (2 V_cell): candidates per ordered pair and unit of relative speed
  const double* factor;       ///< on the pairs of each cell; null without
  const std::uint8_t* still;  ///< not zero for cells whose collisions displace nobody; null without
  double impact_coefficient;  ///< of the fitted distribution of impact parameters
  Phase<D>* particles;
  const std::uint32_t* offsets;
  Tally* tally;
  std::uint64_t* bound_raised;            ///< collisions after which the bound on relative speeds had to rise
  const std::uint8_t* species = nullptr;  ///< of each particle; null where there is one only
  Spin<D>* spins = nullptr;               ///< null where particles do not spin
  const double* contact = nullptr;        ///< of each cell and pair of species, see DensePairs; null without
  double* clocks = nullptr;               ///< of each cell, see CellClocks; null without
};

/// Throws RunError where a cell expects more than a million candidates for each of its particles, or a number that is none:
/// the step is far too long for these speeds, and would take hours.
inline void require_few(double candidates, std::uint32_t particles) {
  if (!(candidates <= 1e6 * particles)) [[unlikely]]
    refuse_candidates(candidates, particles);
}

/// Collides the particles of a range of cells. One implementation per pair rule, chosen once at assembly.
template <int D>
class CollisionStage {
 public:
  virtual ~CollisionStage() = default;
  virtual void collide(const CollisionStep<D>& step, std::uint32_t first_cell,
                       std::uint32_t last_cell) const = 0;
};

template <int D>
std::unique_ptr<CollisionStage<D>> make_collision_stage(const Parameters& parameters);

/// The same kernel with the planted faults of `parameters`, if any. Kept out of the honest kernel: it costs branches.
template <int D>
std::unique_ptr<CollisionStage<D>> make_faulty_collision_stage(const Parameters& parameters);

}  // namespace sandglass::dsmc
