#pragma once

#include "sim/scene/scene.hpp"
#include "sim/scene/text/words.hpp"

#include <optional>

namespace sandglass {

const Words<int>& axis_words();  ///< "x", "y", "z"
const Words<Side>& side_words();
const Words<std::optional<Positions>>& positions_words();  ///< none: "given"
const Words<SurfaceKind>& surface_kind_words();
const Words<std::pair<int, bool>>& wall_side_words();  ///< "x-low": axis, high
const Words<Arrivals>& arrivals_words();
const Words<InflowEntry>& entry_words();
const Words<Piston>& piston_words();

}  // namespace sandglass
