#pragma once

#include "sim/method/mixing/repulsion.hpp"
#include "sim/method/mixing/support.hpp"
#include "sim/method/mixing/wall_rule.hpp"
#include "sim/observe/view.hpp"

#include <optional>
#include <vector>

namespace sandglass::mixing {

/// Faults that the mutant suite plants.
struct Faults {
  double repulsion_sign = 1;
  double first_kick = 0.5;  ///< part of a step
};

/// All that a run of the method needs to know.
struct Parameters {
  Repulsion repulsion;
  WallRule walls;
  double gravity = 0;                        ///< acceleration along y
  std::optional<SupportParameters> support;  ///< none: gravity as it is
  std::vector<SpeciesTraits> species;
  bool keep_ids = false;
  Faults faults;
};

}  // namespace sandglass::mixing
