#include "sim/program/folders.hpp"

#include "sim/base/error.hpp"

#include <cstdlib>
#include <filesystem>

namespace sandglass::program {

std::string home() {
  const char* given = std::getenv("SANDGLASS_HOME");
  const std::string folder = given != nullptr ? given : SANDGLASS_SOURCE_DIR;
  if (!std::filesystem::is_directory(folder + "/validation/case"))
    throw InputError(folder +
                     ": no folder validation/case there; set SANDGLASS_HOME to the source tree of Sandglass");
  return folder;
}

}  // namespace sandglass::program
