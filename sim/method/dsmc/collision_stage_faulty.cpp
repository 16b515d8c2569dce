#include "sim/method/dsmc/collision_kernel.hpp"

namespace sandglass::dsmc {

template <>
std::unique_ptr<CollisionStage<2>> make_faulty_collision_stage(const Parameters& parameters) {
  return choose_kernel<2, Faulty>(parameters);
}

template <>
std::unique_ptr<CollisionStage<3>> make_faulty_collision_stage(const Parameters& parameters) {
  return choose_kernel<3, Faulty>(parameters);
}

}  // namespace sandglass::dsmc
