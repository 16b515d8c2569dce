#pragma once

#include "sim/method/dsmc/collision_kernel.hpp"
#include "sim/method/dsmc/time_counter_kernel.hpp"

namespace sandglass::dsmc {

/// Instantiated in one file per pair rule and dimension, kernel_*.cpp.
template <int D, class Rule>
std::unique_ptr<CollisionStage<D>> make_kernel(const Parameters& parameters) {
  if (parameters.pair_count == PairCount::time_counter)
    return std::make_unique<TimeCounterKernel<D, Rule>>(parameters);
  if (parameters.offset.any()) return std::make_unique<CollisionKernel<D, Rule, true>>(parameters);
  return std::make_unique<CollisionKernel<D, Rule, false>>(parameters);
}

}  // namespace sandglass::dsmc
