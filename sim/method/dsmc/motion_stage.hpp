#pragma once

#include "sim/observe/plane.hpp"
#include "sim/space/particle_store.hpp"

#include <array>
#include <memory>
#include <vector>

namespace sandglass::dsmc {

/// What particles do between collisions.
template <int D>
struct MotionParameters {
  Vector<D> gravity = Vector<D>::Zero();
  std::array<bool, D> walled{};  ///< per axis: specular walls at both ends, else periodic
  bool offsets = false;          ///< collisions may have put particles outside the walls
  std::vector<Plane>* planes = nullptr;
};

/// Free flight over one step, with the boundaries, and the cell where each particle arrives.
template <int D>
class MotionStage {
 public:
  virtual ~MotionStage() = default;
  /// Advances particles [first, last) of the store and counts them into the cells where they arrive.
  virtual void advance(ParticleStore<D>& store, std::size_t first, std::size_t last, double dt) const = 0;
};

template <int D>
std::unique_ptr<MotionStage<D>> make_motion_stage(const MotionParameters<D>& parameters);

}  // namespace sandglass::dsmc
