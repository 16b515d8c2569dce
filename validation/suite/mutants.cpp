#include "validation/suite/mutants.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"

namespace sandglass {

namespace {
std::string summary_of(const std::string& mutation) {
  for (const PlantedFault& info : planted_faults())
    if (info.name == mutation) return info.summary;
  return "";
}

const CheckUse* use_of(const Case& subject, const Mutant& mutant) {
  for (const CheckUse& use : subject.checks)
    if (use.check == mutant.check && use.where.holds(mutant.point, mutant.variant)) return &use;
  throw InputError("case '" + subject.name + "': mutant '" + mutant.mutation + "' names the check '" +
                   mutant.check + "', which the case does not make at point '" + mutant.point +
                   "' of variant '" + mutant.variant + "': add the check there or name another");
}
}  // namespace

Task mutant_task(const Case& subject, const std::string& tier, const Mutant& mutant) {
  return {&subject,
          mutant.variant,
          mutant.point,
          scene_of(subject, tier, mutant.variant, mutant.point, mutant.set),
          {use_of(subject, mutant)}};
}

MutantResult judge_mutant(const Task& task, const Mutant& mutant, const Confidence& confidence) {
  MutantResult result{
      task.subject->name, mutant.mutation, summary_of(mutant.mutation), task.variant, task.point, {}, false};
  RunOptions options;
  options.mutation.name = mutant.mutation;
  CheckUse use = *task.checks.front();
  use.limits.clear();
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
