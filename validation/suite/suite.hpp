#pragma once

#include "validation/suite/keys.hpp"
#include "validation/suite/mutants.hpp"
#include "validation/suite/outcome.hpp"
#include "validation/suite/sweep.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

struct SuiteProgress {
  std::size_t done, total;  ///< runs
  double fraction;          ///< of the expected work
  std::string finished;     ///< "equilibrium-gas/cba/2d-dense"
  double cpu_seconds;       ///< of that run
};

struct SuiteOptions {
  std::string case_folder;         ///< the folder validation/case
  std::vector<std::string> cases;  ///< names; empty: all
  std::string tier = "standard";
  std::string variant;  ///< empty: all
  unsigned jobs = 1;    ///< threads
  std::string output = "report";
  bool mutants = false;                 ///< run the planted faults instead of the matrix
  bool keys = false;                    ///< wire the keys of the scenes wrongly instead
  std::vector<std::string> known_keys;  ///< all that a scene may have
  std::vector<Override> settings = {};  ///< laid over the scene of every run, the later ones on top
  std::optional<std::uint64_t> seed;    ///< fresh seeds derived from this one; without it those of the scenes
  Confidence confidence;
  std::function<void(const SuiteProgress&)> progress;  ///< one call at a time, from any thread; may be empty
  const std::atomic<bool>* stop = nullptr;             ///< set by a signal: throws Interrupted
};

struct SuiteResult {
  std::vector<Case> cases;  ///< what the sweeps below point into
  std::vector<Outcome> outcomes;
  std::vector<SweepResult> sweeps;
  std::vector<MutantResult> mutants;
  std::vector<KeyResult> keys;  ///< block nothing: they say where to look
  /// A verdict that blocks or a mutant that was not caught.
  bool blocked() const;
};

/// Runs the matrix, the mutants or the keys and fills the report folder (docs/file-formats.md). Throws InputError for a
/// case, tier or variant that does not exist and for a scene that cannot be, before anything runs; RunError
/// when nothing can be written. A run that breaks is a verdict: its checks are inconclusive and say why.
SuiteResult run_suite(const SuiteOptions& options);

/// What `list cases` shows.
struct CaseSummary {
  std::string name, topic, summary;
  std::vector<std::string> variants, points, claims;
};
std::vector<CaseSummary> list_cases(const std::string& case_folder);

}  // namespace sandglass
