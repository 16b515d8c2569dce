#include "sim/method/dsmc/collision_kernel.hpp"

namespace sandglass::dsmc {

template <>
std::unique_ptr<CollisionStage<2>> make_collision_stage(const Parameters& parameters) {
  return choose_kernel<2, Honest>(parameters);
}

}  // namespace sandglass::dsmc
