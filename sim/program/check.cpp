#include "validation/check/check.hpp"

#include "sim/base/error.hpp"
#include "sim/program/options.hpp"
#include "sim/program/table.hpp"
#include "sim/record/describe.hpp"
#include "validation/judge/judge.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace sandglass::program {

namespace {

/// What the scene's own checks would need: the remedy for a record that none can read.
std::string missing_series(const Record& record) {
  const Scene scene = read_scene_text(record.scene, "scene of the record");
  std::string list;
  for (const CheckInfo& info : all_checks())
    if (info.applies(scene)) list += fmt::format("\n  {}: {}", info.name, fmt::join(info.needs, ", "));
  if (list.empty()) return "None holds for a scene like this one; 'sandglass list checks' names them all.";
  return "Checks that hold for this scene, and the series that they need (observe them and run again):" +
         list;
}

/// What the check finds; where the record is too short for it, nothing but that.
struct Finding {
  Evidence evidence;
  Judgement judgement;
};

Finding find(const CheckInfo& info, const Record& record) {
  try {
    const Evidence evidence = run_check(info, record, {});
    return {evidence, judge(evidence, {}, false)};
  } catch (const InputError& error) {
    Evidence nothing;
    nothing.check = info.name;
    nothing.value = nothing.standard_error = nothing.expected = std::nan("");
    return {nothing,
            {Verdict::inconclusive, nothing.value, nothing.value, error.diagnostics().front().message}};
  }
}

nlohmann::json as_json(const Finding& finding) {
  const auto& [evidence, judgement] = finding;
  return {{"check", evidence.check},
          {"verdict", to_string(judgement.verdict)},
          {"reason", judgement.reason},
          {"value", evidence.value},
          {"stderr", evidence.standard_error},
          {"kind", to_string(evidence.kind)},
          {"expected", evidence.expected},
          {"budget", judgement.budget},
          {"units", evidence.units}};
}

std::vector<std::string> row_of(const Finding& finding) {
  const auto& [evidence, judgement] = finding;
  return {evidence.check,
          to_string(judgement.verdict),
          fmt::format("{:.6g}", evidence.value),
          fmt::format("{:.2g}", evidence.standard_error),
          expectation_text(evidence),
          fmt::format("{:.2g}", judgement.budget),
          evidence.units};
}

}  // namespace

int check(const Options& options) {
  const Record record = read_record(options.subject);
  const std::vector<const CheckInfo*> checks = checks_for(record);
  if (checks.empty()) throw InputError(options.subject + ": no check applies.\n" + missing_series(record));
  nlohmann::json json = nlohmann::json::array();
  std::vector<std::vector<std::string>> rows = {
      {"check", "verdict", "value", "standard error", "expected", "budget", "units"}};
  bool all_hold = record.broken.empty();
  std::string reasons;
  for (const CheckInfo* info : checks) {
    const Finding finding = find(*info, record);
    rows.push_back(row_of(finding));
    json.push_back(as_json(finding));
    if (!blocks(finding.judgement.verdict)) continue;
    all_hold = false;
    reasons += fmt::format("{}: {}\n", finding.evidence.check, finding.judgement.reason);
  }
  fmt::print("{}",
             options.json ? json.dump(2) + "\n" : describe_record(record) + "\n" + columns(rows) + reasons);
  return all_hold ? all_well : verdict_fails;
}

}  // namespace sandglass::program
