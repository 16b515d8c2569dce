#pragma once

#include "validation/suite/outcome.hpp"

#include <string>
#include <vector>

namespace sandglass {

struct MutantResult {
  std::string case_name, fault, summary;
  std::string variant, point;
  CheckOutcome check;
  bool caught = false;
  double cpu_seconds = 0;  ///< of all its runs
};

/// The run of a mutant and its one check. The known limits of the case do not count: a mutant must fail.
Task mutant_task(const Case& subject, const std::string& tier, const Mutant& mutant);

/// Runs the scene with the fault planted; caught when the check fails, and does not without the fault. A run that breaks
/// catches nothing and says why.
MutantResult judge_mutant(const Task& task, const Mutant& mutant, const Confidence& confidence);

/// A check that a case makes of a method family without planting any fault that it must see there.
struct UntestedCheck {
  std::string check, family;
  auto operator<=>(const UntestedCheck&) const = default;
};

/// Empty for a complete case. A check that is a known limit wherever the family faces it needs none: passing is an alarm.
std::vector<UntestedCheck> untested_checks(const Case& subject);

}  // namespace sandglass
