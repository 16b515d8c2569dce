#pragma once

#include <string>
#include <vector>

namespace sandglass::program {

/// Rows in columns as wide as they need, two blanks apart; the last column is free.
std::string columns(const std::vector<std::vector<std::string>>& rows);

}  // namespace sandglass::program
