#include "validation/suite/mutants.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "validation/suite/apart.hpp"

#include <algorithm>
#include <set>

namespace sandglass {

namespace {
std::string summary_of(const std::string& fault) {
  for (const PlantedFault& info : planted_faults())
    if (info.name == fault) return info.summary;
  return "";
}

/// The same run without the fault, where it is not one of the matrix: what the fault's run changes beside the fault must not
/// be what the check sees. It may be too short to be conclusive.
void judge_twin(const Task& twin, const Confidence& confidence, MutantResult& result) {
  const Record record = run_scene_apart(twin.scene, {});
  result.cpu_seconds += record.timings.at("cpu-seconds");
  const auto lock = hold_off_new_processes();
  CheckOutcome honest = judge_record(twin, record, confidence).front();
  if (honest.judgement.verdict != Verdict::fail) return;
  honest.judgement.reason = "the same run without the fault fails too: " + honest.judgement.reason;
  result.check = std::move(honest);
  result.caught = false;
}
}  // namespace

Task mutant_task(const Case& subject, const std::string& tier, const Mutant& mutant) {
  return {&subject,
          mutant.variant,
          mutant.point,
          scene_of(subject, tier, mutant.variant, mutant.point, mutant.set),
          {subject.use_of(mutant.check, mutant.point, mutant.variant)}};
}

MutantResult judge_mutant(const Task& task, const Mutant& mutant, const Confidence& confidence) {
  MutantResult result{
      task.subject->name, mutant.fault, summary_of(mutant.fault), task.variant, task.point, {}, false};
  RunOptions options;
  options.planted_fault = mutant.fault;
  CheckUse use = *task.checks.front();
  use.limits.clear();
  for (const auto& [name, value] : mutant.numbers) use.settings.numbers[name] = value;
  Task twin = task;
  twin.checks = {&use};
  try {
    const Record record = run_scene_apart(task.scene, options);
    result.cpu_seconds = record.timings.at("cpu-seconds");
    {
      const auto lock = hold_off_new_processes();
      result.check = judge_record(twin, record, confidence).front();
    }
    result.caught = result.check.judgement.verdict == Verdict::fail;
    if (result.caught && mutant.differs()) judge_twin(twin, confidence, result);
  } catch (const RunError& error) {
    const auto lock = hold_off_new_processes();
    result.check = judge_broken(twin, error.what(), confidence).front();
    result.caught = false;
  }
  return result;
}

std::vector<UntestedCheck> untested_checks(const Case& subject) {
  std::set<UntestedCheck> wanted;
  for (const std::string& tier : tier_names())
    for (const Task& task : expand(subject, tier, ""))
      for (const CheckUse* use : task.checks)
        if (!use->known_limit(task.point, task.variant))
          wanted.insert({use->check, method_family(task.scene)});
  for (const Mutant& mutant : subject.mutants)
    wanted.erase({mutant.check, method_family(scene_of(subject, "", mutant.variant, mutant.point, {}))});
  return {wanted.begin(), wanted.end()};
}

}  // namespace sandglass
