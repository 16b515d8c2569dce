#pragma once

#include <string>

namespace sandglass::program {

/// Where the cases and the ledger of claims are: $SANDGLASS_HOME, else the source tree that the program was built from.
/// Throws InputError when it is not there.
std::string home();
inline std::string case_folder() { return home() + "/validation/case"; }
inline std::string scene_page() { return home() + "/docs/scene.md"; }
inline std::string claims_file() { return home() + "/reference/claims.toml"; }

}  // namespace sandglass::program
