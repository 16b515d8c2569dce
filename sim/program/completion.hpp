#pragma once

#include <string>

namespace CLI {
class App;
}

namespace sandglass::program {

/// A script that completes the commands of the program, their options and what they take in a shell, "bash" or "zsh".
/// Throws InputError for another one.
std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace sandglass::program
