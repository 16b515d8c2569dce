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

/// Where and when a particle comes in during a step.
struct Arrival {
  int axis = 0;
  bool high = false;
  double left = 0;  ///< of the step, from then on
};

/// Particles that come in during a step, each as it stands and moves on its way through the side.
template <int D>
struct Entrants {
  Particles<D> particles;
  std::vector<Arrival> arrivals;  ///< of each
};

}  // namespace sandglass
