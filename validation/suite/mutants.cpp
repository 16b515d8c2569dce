#include "validation/suite/mutants.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

namespace sandglass {

namespace {
std::string summary_of(const std::string& mutation) {
  for (const MutationInfo& info : mutations())
    if (info.name == mutation) return info.summary;
  return "";
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
      task.subject->name, mutant.mutation, summary_of(mutant.mutation), task.variant, task.point, {}, false};
  RunOptions options;
  options.mutation.name = mutant.mutation;
  CheckUse use = *task.checks.front();
  use.limits.clear();
  for (const auto& [name, value] : mutant.numbers) use.settings.numbers[name] = value;
  Task honest = task;
  honest.checks = {&use};
  try {
    result.check = judge_record(honest, run_scene(task.scene, options), confidence).front();
  } catch (const RunError& error) {
    result.check = judge_broken(honest, error.what(), confidence).front();
  }
  result.caught = result.check.judgement.verdict == Verdict::fail;
  return result;
}

}  // namespace sandglass
