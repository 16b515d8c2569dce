#pragma once

#include "sim/record/record.hpp"
#include "sim/scene/scene.hpp"

namespace sandglass {

/// Throws InputError for the state of a checkpoint that no run of the scene can have left, whatever its method: numbers that
/// are not finite, particles beyond the box, species that the scene does not have, a clock that its steps do not give.
/// What a family keeps beside that it checks itself.
void require_sound(const State& state, const Scene& scene);

}  // namespace sandglass
