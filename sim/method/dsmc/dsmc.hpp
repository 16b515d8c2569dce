#pragma once

#include <memory>
#include <optional>

#include "sim/method/dsmc/collision_stage.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/method/dsmc/motion_stage.hpp"

namespace sandglass::dsmc {

/// Direct simulation Monte Carlo and its dense-gas variants in D dimensions. A step collides the particles of each cell,
/// moves them, and sorts them into the cells where they arrive.
template <int D>
class Dsmc {
 public:
  Dsmc(const Grid<D>& grid, const Parameters& parameters, const MotionParameters<D>& motion, bool keep_ids);

  /// Takes the particles; what depends on their number is set up here.
  void assign(std::span<const Phase<D>> particles, std::span<const std::uint64_t> ids = {});

  /// One step of length `dt`. `key` names the random streams of its cells.
  void step(double dt, const StreamKey& key);

  const ParticleStore<D>& store() const { return store_; }
  Tally& tally() { return tally_; }
  const Tally& tally() const { return tally_; }
  const Parameters& parameters() const { return parameters_; }
  /// Bytes held by the method, everything included.
  std::size_t bytes() const;

 private:
  void collide_and_move(double dt, const CollisionStep<D>& collisions);

  Parameters parameters_;
  MotionParameters<D> motion_parameters_;
  ParticleStore<D> store_;
  std::unique_ptr<CollisionStage<D>> collisions_;
  std::unique_ptr<MotionStage<D>> motion_;
  std::optional<LocalContactFactor<D>> factor_;
  Tally tally_;
};

extern template class Dsmc<2>;
extern template class Dsmc<3>;

}  // namespace sandglass::dsmc
