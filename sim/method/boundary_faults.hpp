#pragma once

#include "sim/method/planted_fault.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass {

using SceneChange = void (*)(Scene&);

/// Faults of walls, obstacles and gravity, for every family that has them: changes of the scene that the family, the
/// sources and the time step get, made after the particles were placed.
const std::vector<FaultEntry<SceneChange>>& boundary_faults();
/// Those of open sides, sources and inflows, for every family whose number of particles may change.
const std::vector<FaultEntry<SceneChange>>& exchange_faults();

/// Those of the time step, for every family that moves its particles from cell to cell.
const std::vector<FaultEntry<SceneChange>>& step_faults();

/// The scene with that fault planted, if it is one of them.
Scene with_scene_fault(const Scene& scene, const std::string& name);

}  // namespace sandglass
