#include "sim/method/dsmc/collision_stage.hpp"

#include "sim/base/error.hpp"
#include "sim/method/dsmc/dense_pairs.hpp"
#include "sim/method/dsmc/faulty_pairs.hpp"
#include "sim/method/dsmc/fitted_pairs.hpp"
#include "sim/method/dsmc/mixed_pairs.hpp"
#include "sim/method/dsmc/rough_pairs.hpp"

#include <type_traits>

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

namespace {
/// Calls `make` with the pair rule of these parameters.
template <int D, class Make>
auto with_rule(const Parameters& parameters, Make make) {
  const bool mixed = parameters.kinds.mixed(), dense = has_factors_of_species(parameters);
  if (parameters.kinds.rough)
    return dense ? make(std::type_identity<DensePairs<D, RoughPairs<D>>>{})
                 : make(std::type_identity<RoughPairs<D>>{});
  if (mixed)
    return dense ? make(std::type_identity<DensePairs<D, MixedPairs<D>>>{})
                 : make(std::type_identity<MixedPairs<D>>{});
  if (parameters.impact.fitted()) return make(std::type_identity<FittedPairs<D>>{});
  return make(std::type_identity<SmoothPairs<D>>{});
}
}  // namespace

template <int D>
std::unique_ptr<CollisionStage<D>> make_collision_stage(const Parameters& parameters) {
  return with_rule<D>(parameters,
                      [&]<class Rule>(std::type_identity<Rule>) { return make_kernel<D, Rule>(parameters); });
}

template <int D>
std::unique_ptr<CollisionStage<D>> make_faulty_collision_stage(const Parameters& parameters) {
  return with_rule<D>(parameters, [&]<class Rule>(std::type_identity<Rule>) {
    return make_kernel<D, FaultyPairs<D, Rule>>(parameters);
  });
}

template std::unique_ptr<CollisionStage<2>> make_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<2>> make_faulty_collision_stage(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_faulty_collision_stage(const Parameters&);

}  // namespace sandglass::dsmc
