#pragma once

#include <string>
#include <vector>

namespace sandglass::program {

/// A row of the ledger of claims.
struct Claim {
  std::string id, source, text, status;
  std::vector<std::string> evidence;  ///< names of cases
};

/// Throws InputError with file and line when the ledger cannot be read.
std::vector<Claim> read_claims(const std::string& path);

}  // namespace sandglass::program
