#include "sim/program/claims.hpp"

#include "sim/base/error.hpp"

#include <toml++/toml.h>

namespace sandglass::program {

namespace {
Claim claim_of(const toml::table& row, const std::string& path) {
  const auto text = [&](const char* key) {
    if (const auto value = row[key].value<std::string>()) return *value;
    throw InputError({{path, static_cast<int>(row.source().begin.line), 1,
                       std::string("a claim needs the key '") + key + "'"}});
  };
  Claim claim{text("id"), text("source"), text("text"), text("status"), {}};
  if (const toml::array* cases = row["evidence"].as_array())
    for (const toml::node& name : *cases) claim.evidence.push_back(name.value_or(std::string()));
  return claim;
}
}  // namespace

std::vector<Claim> read_claims(const std::string& path) {
  std::vector<Claim> claims;
  try {
    const toml::table ledger = toml::parse_file(path);
    if (const toml::array* rows = ledger["claim"].as_array())
      for (const toml::node& row : *rows) claims.push_back(claim_of(*row.as_table(), path));
  } catch (const toml::parse_error& error) {
    throw InputError({{path, static_cast<int>(error.source().begin.line),
                       static_cast<int>(error.source().begin.column), std::string(error.description())}});
  }
  return claims;
}

}  // namespace sandglass::program
