#pragma once

#include <string>
#include <vector>

namespace sandglass::program {

/// A complete scene to start from: a file of docs/examples.
struct Template {
  std::string name;     ///< of the file, without .toml
  std::string summary;  ///< title of the scene
  std::string path;
};

/// By name. Throws InputError when the source tree is not there.
std::vector<Template> templates();

}  // namespace sandglass::program
