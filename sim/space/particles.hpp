#pragma once

#include "sim/base/columns.hpp"
#include "sim/base/particle_columns.hpp"
#include "sim/space/phase.hpp"

#include <vector>

namespace sandglass {

/// Particles outside a method: what it starts from, or what it is to add. Columns hold one value per particle each.
template <int D>
struct Particles {
  std::vector<Phase<D>> phases;
  Columns columns;
};

}  // namespace sandglass
