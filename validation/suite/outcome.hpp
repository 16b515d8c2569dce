#pragma once

#include "sim/record/record.hpp"
#include "validation/judge/judge.hpp"
#include "validation/suite/matrix.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// What one run cost and where it came from.
struct RunSummary {
  std::string variant, point;
  std::uint64_t seed = 0;
  std::string scene;        ///< TOML text, as resolved
  std::string record_path;  ///< relative to the report folder
  double cpu_seconds = 0, wall_seconds = 0, peak_bytes = 0;
  double work = 0;  ///< particle-moves
  std::map<std::string, double> counters;
  Provenance provenance;
};

/// One verdict with everything behind it.
struct CheckOutcome {
  std::string claim;
  Evidence evidence;
  Judgement judgement;
  bool known_limit = false;
  std::string limit_reason;
};

/// One run and its verdicts.
struct Outcome {
  std::string case_name, tier;
  RunSummary run;
  std::vector<CheckOutcome> checks;
  std::vector<CheckOutcome> first_attempt;  ///< of a run that was repeated once, longer and with another seed
  std::uint64_t first_seed = 0;
};

/// Holds a record against the checks of a case. A check that cannot be evaluated is inconclusive and says
/// why.
std::vector<CheckOutcome> judge_record(const Task& task, const Record& record, const Confidence& confidence);

/// A run that broke: every check is inconclusive and gives the reason.
std::vector<CheckOutcome> judge_broken(const Task& task, const std::string& reason,
                                       const Confidence& confidence);

/// Cost and provenance out of a record.
RunSummary summarize(const Task& task, const Record& record);

/// Any verdict that blocks and rests on statistics: worth one longer run with another seed.
bool worth_escalation(const Outcome& outcome);

}  // namespace sandglass
