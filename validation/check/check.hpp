#pragma once

#include "validation/check/evidence.hpp"
#include "validation/check/subject.hpp"
#include "validation/law/law.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sandglass {

/// What a case gives a check: its own numbers, and the part of the budget that only the case can know.
struct Settings {
  law::Arguments numbers;  ///< by the names in CheckInfo::parameters; absent ones take their fallback
  double systematic = 0;   ///< added to the check's own systematic part; a fraction when CheckInfo::relative
  double resolution = 0;   ///< a fraction when CheckInfo::relative
  std::string reason;      ///< where `systematic` comes from
};

/// An estimator and what it is held against. It sees the record alone and returns numbers, never a verdict.
struct CheckInfo {
  std::string name;
  std::string summary;
  std::string law;                 ///< in the registry of laws; empty for a conservation law
  std::vector<std::string> needs;  ///< series that the record must hold
  bool relative = true;            ///< the case states its budget as a fraction of the expected value
  std::vector<law::Parameter> parameters;
  std::function<bool(const Scene&)> applies;  ///< whether the law holds for such a scene at all
  std::function<Evidence(const Subject&, const law::Arguments&)> evaluate;
  bool weighs = false;  ///< reads what counts real particles, so that regions of other weights may be there
};

const std::vector<CheckInfo>& all_checks();
/// Throws InputError naming the nearest spelling.
const CheckInfo& find_check(const std::string& name);
/// Checks that apply to the scene, find the series that they need in the record, and need no number of a case.
std::vector<const CheckInfo*> checks_for(const Record& record);

/// Evaluates and adds the case's part of the budget. Throws InputError when a number is unknown or out of
/// range, or a series is missing.
Evidence run_check(const CheckInfo& check, const Record& record, const Settings& settings);

}  // namespace sandglass
