#pragma once

#include "sim/scene/scene.hpp"
#include "validation/suite/case.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// A base scene with overrides laid over it, later ones on top, and read as a scene. A table goes into the
/// table of the same name; a table over [[species]] goes into its first entry; an empty table removes what
/// was there; everything else replaces it. Factors multiply what stands there at their turn; the added observers come last.
/// Throws InputError; an error that an override brought in is placed where the override stands.
Scene lay_over(const Node& base, const std::string& base_file, const std::vector<const Override*>& overrides,
               const std::vector<AddedObservers>& added = {});

}  // namespace sandglass
