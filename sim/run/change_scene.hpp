#pragma once

#include "sim/record/record.hpp"
#include "sim/scene/scene.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// Lets a run go on from a checkpoint with another scene than it had: with what cannot alter its past, which is the
/// duration, the collapse guard, the observers and the cadences of the output. The record says so with `words`, one for each
/// change. Throws InputError for any other difference.
void change_scene(Record& checkpoint, const Scene& changed, const std::vector<std::string>& words);

}  // namespace sandglass
