#include "validation/suite/run_task.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "validation/suite/apart.hpp"

#include <filesystem>

namespace sandglass {

namespace {
constexpr std::uint64_t escalation = 4;  // times the replicas, once

std::string name_of(const Task& task) { return task.subject->name + "/" + task.variant + "/" + task.point; }

Outcome broken(const Task& task, const std::string& reason, const Confidence& confidence) {
  Outcome outcome;
  outcome.run.variant = task.variant;
  outcome.run.point = task.point;
  outcome.run.seed = task.scene.run.seed;
  outcome.run.scene = write_scene(task.scene);  // to run it again: there is no record
  outcome.checks = judge_broken(task, reason, confidence);
  return outcome;
}

Outcome attempt(const Task& task, const SuiteOptions& options, const std::string& record_path) {
  RunOptions run;
  run.stop = options.stop;
  Outcome outcome;
  try {
    const Record record = run_scene_apart(
        task.scene, run,
        record_path.empty() ? "" : (std::filesystem::path(options.output) / record_path).string());
    const auto lock = hold_off_new_processes();
    outcome.run = summarize(task, record);
    outcome.checks = judge_record(task, record, options.confidence);
    outcome.run.record_path = record_path;
  } catch (const RunError& error) {
    const auto lock = hold_off_new_processes();
    outcome = broken(task, error.what(), options.confidence);
  }
  outcome.case_name = task.subject->name;
  outcome.tier = options.tier;
  return outcome;
}
}  // namespace

Outcome run_task(const Task& task, const SuiteOptions& options, const std::string& record_path) {
  if (!options.seed) return attempt(task, options, record_path);
  Task fresh = task;
  fresh.scene.run.seed = derived_seed(*options.seed, name_of(task));
  Outcome first = attempt(fresh, options, record_path);
  if (!worth_escalation(first)) return first;
  fresh.scene.run.replicas *= escalation;
  fresh.scene.run.seed = derived_seed(*options.seed, name_of(task) + "/again");
  Outcome second = attempt(fresh, options, record_path);
  second.first_attempt = std::move(first.checks);
  second.first_seed = first.run.seed;
  return second;
}

void ProgressCounter::finished(const std::string& name, double work, double cpu_seconds) {
  const std::lock_guard lock(mutex_);
  ++done_;
  work_done_ += work;
  if (report_) report_({done_, runs_, work_ > 0 ? work_done_ / work_ : 1, name, cpu_seconds});
}

double expected_work(const Scene& scene) {
  const double moves = plan(scene).particle_moves;
  return moves > 0 ? moves : 1;
}

}  // namespace sandglass
