#include "sim/method/dsmc/collision_kernel.hpp"

namespace sandglass::dsmc {

template <>
std::unique_ptr<CollisionStage<3>> make_collision_stage(const Parameters& parameters) {
  return choose_kernel<3, Honest>(parameters);
}

}  // namespace sandglass::dsmc
