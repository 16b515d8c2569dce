#pragma once

#include "sim/motion/parameters.hpp"
#include "sim/space/particle_store.hpp"

#include <memory>

namespace sandglass::motion {

/// Free flight over one step, with walls and obstacles, and the cell where each particle arrives.
template <int D>
class MotionStage {
 public:
  virtual ~MotionStage() = default;
  /// Advances particles [first, last) of the store and counts them into the cells where they arrive.
  virtual void advance(ParticleStore<D>& store, std::size_t first, std::size_t last,
                       const MotionStep& step) const = 0;
};

/// The box begins at the origin. Throws InputError for surroundings that make no sense together.
template <int D>
std::unique_ptr<MotionStage<D>> make_motion_stage(const MotionParameters<D>& parameters,
                                                  const Vector<D>& box);

extern template std::unique_ptr<MotionStage<2>> make_motion_stage(const MotionParameters<2>&,
                                                                  const Vector<2>&);
extern template std::unique_ptr<MotionStage<3>> make_motion_stage(const MotionParameters<3>&,
                                                                  const Vector<3>&);

}  // namespace sandglass::motion
