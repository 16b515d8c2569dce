#include "validation/suite/outcome.hpp"

#include <exception>
#include <limits>

#include <fmt/format.h>

namespace sandglass {

namespace {
double at_or_zero(const std::map<std::string, double>& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? 0 : found->second;
}

/// Evidence that says nothing, so that the judge blocks it.
Evidence nothing_known(const std::string& check) {
  Evidence evidence;
  evidence.check = check;
  evidence.summary = find_check(check).summary;
  evidence.law = find_check(check).law;
  evidence.value = evidence.standard_error = evidence.expected = std::numeric_limits<double>::quiet_NaN();
  return evidence;
}

/// A known limit has a sign and a size: with the numbers that say what is seen instead the check must pass.
void demand_instead(const KnownLimit& limit, const CheckUse& use, const Record& record,
                    const Confidence& confidence, Judgement& judgement) {
  Settings settings = use.settings;
  for (const auto& [name, value] : limit.instead) settings.numbers[name] = value;
  const Evidence seen = run_check(find_check(use.check), record, settings);
  const Judgement instead = judge(seen, confidence, false);
  judgement.reason += fmt::format("; instead {:.5g} is expected there: {}", seen.expected, instead.reason);
  if (instead.verdict != Verdict::pass) judgement.verdict = Verdict::fail;
}

CheckOutcome judge_one(const CheckUse& use, const Task& task, const Record& record,
                       const Confidence& confidence) {
  CheckOutcome outcome;
  outcome.claim = use.claim;
  const KnownLimit* limit = use.known_limit(task.point, task.variant);
  outcome.known_limit = limit != nullptr;
  if (limit) outcome.limit_reason = limit->reason;
  std::string failure;
  try {
    outcome.evidence = run_check(find_check(use.check), record, use.settings);
  } catch (const std::exception& error) {  // whatever a wrong record brings a check to
    outcome.evidence = nothing_known(use.check);
    failure = error.what();
  }
  outcome.judgement = judge(outcome.evidence, confidence, outcome.known_limit);
  if (!failure.empty()) outcome.judgement.reason = failure;
  if (outcome.judgement.verdict == Verdict::expected_fail && !limit->instead.empty())
    demand_instead(*limit, use, record, confidence, outcome.judgement);
  return outcome;
}
}  // namespace

std::vector<CheckOutcome> judge_record(const Task& task, const Record& record, const Confidence& confidence) {
  std::vector<CheckOutcome> outcomes;
  for (const CheckUse* use : task.checks) outcomes.push_back(judge_one(*use, task, record, confidence));
  return outcomes;
}

std::vector<CheckOutcome> judge_broken(const Task& task, const std::string& reason,
                                       const Confidence& confidence) {
  std::vector<CheckOutcome> outcomes = judge_record(task, Record{}, confidence);
  for (CheckOutcome& check : outcomes) check.judgement.reason = "the run broke: " + reason;
  return outcomes;
}

RunSummary summarize(const Task& task, const Record& record) {
  RunSummary run;
  run.variant = task.variant;
  run.point = task.point;
  run.seed = task.scene.run.seed;
  run.scene = record.scene;
  run.cpu_seconds = at_or_zero(record.timings, "cpu-seconds");
  run.wall_seconds = at_or_zero(record.timings, "wall-seconds");
  run.peak_bytes = at_or_zero(record.timings, "peak-bytes");
  for (const Replica& replica : record.replicas)
    for (const auto& [name, count] : replica.counters) run.counters[name] += count;
  run.work = at_or_zero(run.counters, "particle-moves");
  run.provenance = record.provenance;
  return run;
}

bool worth_escalation(const Outcome& outcome) {
  for (const CheckOutcome& check : outcome.checks)
    if (blocks(check.judgement.verdict) && check.evidence.standard_error > 0) return true;
  return false;
}

}  // namespace sandglass
