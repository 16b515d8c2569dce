#pragma once

#include "sim/scene/scene.hpp"

#include <string>
#include <vector>

namespace sandglass::program {

/// The scene of a file with settings "key=value" of the command line laid over it, the later ones on top. A key is written
/// as in TOML with dots ("method.time-step.steps"), where one of several tables is meant the first ("species.restitution");
/// a value as in TOML, or as a plain word. A table goes into the table that stands there, {} removes it. Throws InputError; what a setting got wrong names the setting.
Scene read_edited_scene(const std::string& path, const std::vector<std::string>& settings);

}  // namespace sandglass::program
