#pragma once

#include "sim/scene/scene.hpp"
#include "validation/suite/case.hpp"

#include <string>
#include <vector>

namespace sandglass::program {

/// Settings "key=value" as what they lay over a scene. Throws InputError naming the setting.
std::vector<Override> overrides_of(const std::vector<std::string>& settings);

/// The scene of a file with settings "key=value" of the command line laid over it, the later ones on top. A key is written
/// as in TOML with dots ("method.time-step.steps"), where one of several tables is meant the first ("species.restitution");
/// a value as in TOML, or as a plain word. A table goes into the table that stands there, {} removes it. Throws InputError; what a setting got wrong names the setting.
Scene read_edited_scene(const std::string& path, const std::vector<std::string>& settings);
/// The same of a text, which errors call `name`.
Scene edited_scene(const std::string& text, const std::string& name,
                   const std::vector<std::string>& settings);

}  // namespace sandglass::program
