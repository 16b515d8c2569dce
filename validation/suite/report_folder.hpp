#pragma once

#include "validation/suite/keys.hpp"
#include "validation/suite/mutants.hpp"
#include "validation/suite/outcome.hpp"
#include "validation/suite/sweep.hpp"

#include <string>
#include <vector>

namespace sandglass {

// The files of a report folder, docs/file-formats.md. All throw RunError naming the path and the reason.

void write_verdicts(const std::string& folder, const std::vector<Outcome>& outcomes);
/// evidence/<case>.json
void write_evidence(const std::string& folder, const Case& subject, const std::vector<Outcome>& outcomes);
void write_sweeps(const std::string& folder, const std::vector<SweepResult>& sweeps);
void write_mutants(const std::string& folder, const std::vector<MutantResult>& mutants);
void write_keys(const std::string& folder, const std::vector<KeyResult>& keys);

}  // namespace sandglass
