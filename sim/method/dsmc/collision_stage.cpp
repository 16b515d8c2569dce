#include "sim/method/dsmc/collision_stage.hpp"

#include "sim/base/error.hpp"
#include "sim/method/dsmc/faulty_pairs.hpp"
#include "sim/method/dsmc/fitted_pairs.hpp"
#include "sim/method/dsmc/mixed_pairs.hpp"
#include "sim/method/dsmc/rough_pairs.hpp"

#include <fmt/format.h>

namespace sandglass::dsmc {

void refuse_candidates(double candidates, std::uint32_t particles) {
  throw RunError(
      fmt::format("a cell of {} particles expects {:.3g} pairs in one step: too long a time step for these "
                  "speeds, or too strong a force? shorten 'method.time-step'",
                  particles, candidates));
}

/// Instantiated in one file per pair rule and dimension, kernel_*.cpp.
template <int D, class Rule>
std::unique_ptr<CollisionStage<D>> make_kernel(const Parameters& parameters);

template <int D>
std::unique_ptr<CollisionStage<D>> make_collision_stage(const Parameters& parameters) {
  if (parameters.kinds.rough) return make_kernel<D, RoughPairs<D>>(parameters);
  if (parameters.kinds.mixed()) return make_kernel<D, MixedPairs<D>>(parameters);
  if (parameters.impact.fitted()) return make_kernel<D, FittedPairs<D>>(parameters);
  return make_kernel<D, SmoothPairs<D>>(parameters);
}

template <int D>
std::unique_ptr<CollisionStage<D>> make_faulty_collision_stage(const Parameters& parameters) {
  if (parameters.kinds.rough) return make_kernel<D, FaultyPairs<D, RoughPairs<D>>>(parameters);
  if (parameters.kinds.mixed()) return make_kernel<D, FaultyPairs<D, MixedPairs<D>>>(parameters);
  if (parameters.impact.fitted()) return make_kernel<D, FaultyPairs<D, FittedPairs<D>>>(parameters);
  return make_kernel<D, FaultyPairs<D, SmoothPairs<D>>>(parameters);
}

template std::unique_ptr<CollisionStage<2>> make_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<2>> make_faulty_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_faulty_collision_stage(const Parameters&);

}  // namespace sandglass::dsmc
