#pragma once

#include "sim/method/builder.hpp"
#include "sim/method/region_weights.hpp"
#include "sim/run/run.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace sandglass {

/// What the scene decides before anything runs.
template <int D>
struct Setup {
  Scene scene;  ///< with every choice that assembly made
  std::vector<ObserverSpec> observers;
  std::unique_ptr<MethodBuilder<D>> method;
  std::uint64_t particles;                       ///< at time zero
  std::vector<Source> sources;                   ///< of the scene, with a fault if one is planted into them
  std::vector<Inflow> inflows;                   ///< the same
  TimeStep time_step;                            ///< the same
  std::optional<RegionWeights<D>> weights = {};  ///< without regions none
};

/// Throws InputError for a combination that the method cannot do.
template <int D>
Setup<D> set_up(const Scene& scene, const std::string& planted_fault);

/// What it needs and costs, as plan().
template <int D>
Plan plan_of(const Setup<D>& setup);

/// What all observers together need.
Needs needs_of(const std::vector<ObserverSpec>& observers);

/// One plane per observer that needs one, in order.
std::vector<Plane> make_planes(const std::vector<ObserverSpec>& observers);

}  // namespace sandglass
