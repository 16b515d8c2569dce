#pragma once

#include <string>

namespace sandglass {

/// The text of a scene file. Throws InputError when it cannot be read.
std::string scene_file_text(const std::string& path);

}  // namespace sandglass
