#include "validation/suite/suite.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "validation/suite/pool.hpp"
#include "validation/suite/report_folder.hpp"
#include "validation/suite/run_task.hpp"

#include <algorithm>
#include <numeric>

namespace sandglass {

namespace {
void require_known(const std::string& kind, const std::string& word,
                   const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    throw InputError(unknown_word(kind, word, allowed));
}

std::vector<Case> chosen_cases(const SuiteOptions& options) {
  std::vector<Case> all = read_cases(options.case_folder);
  std::vector<std::string> names, variants;
  for (const Case& subject : all) {
    names.push_back(subject.name);
    for (const Variant& variant : subject.variants)
      if (std::find(variants.begin(), variants.end(), variant.name) == variants.end())
        variants.push_back(variant.name);
  }
  require_known("tier", options.tier, tier_names());
  if (!options.variant.empty()) require_known("variant", options.variant, variants);
  for (const std::string& name : options.cases) require_known("case", name, names);
  const auto unwanted = [&](const Case& subject) {
    const auto& wanted = options.cases;
    return !wanted.empty() && std::find(wanted.begin(), wanted.end(), subject.name) == wanted.end();
  };
  std::erase_if(all, unwanted);
  for (Case& subject : all) subject.settings = options.settings;
  return all;
}

std::string record_path(const Task& task) {
  return "records/" + task.subject->name + "/" + task.variant + "/" + task.point + ".h5";
}

/// Runs `run(i)` for every task, the longest first, so that no thread is left alone with a long one.
template <class Run>
void run_all(const std::vector<Task>& tasks, const SuiteOptions& options, Run run) {
  std::vector<double> work;
  for (const Task& task : tasks) work.push_back(expected_work(task.scene));
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
  ProgressCounter progress(options, tasks.size(), std::accumulate(work.begin(), work.end(), 0.0));
  std::vector<std::function<void()>> jobs;
  for (const std::size_t i : order)
    jobs.emplace_back([&, i] {
      const double cpu_seconds = run(i);
      const Task& task = tasks[i];
      progress.finished(task.subject->name + "/" + task.variant + "/" + task.point, work[i], cpu_seconds);
    });
  run_in_parallel(options.jobs, jobs);
}

/// A stretch of the task list that belongs to one sweep.
struct SweepRange {
  const Case* subject;
  const Sweep* sweep;
  std::size_t first, count;
};

/// Matrix first, then the runs of the sweeps.
struct Workload {
  std::vector<Task> tasks;
  std::size_t matrix = 0;
  std::vector<SweepRange> sweeps;
};

Workload collect(const std::vector<Case>& cases, const SuiteOptions& options) {
  Workload load;
  for (const Case& subject : cases)
    for (Task& task : expand(subject, options.tier, options.variant)) load.tasks.push_back(std::move(task));
  load.matrix = load.tasks.size();
  for (const Case& subject : cases) {
    if (!subject.tier(options.tier).sweeps) continue;
    for (const Sweep& sweep : subject.sweeps) {
      if (!options.variant.empty() && sweep.variant != options.variant) continue;
      const std::vector<Task> tasks = sweep_tasks(subject, options.tier, sweep);
      load.sweeps.push_back({&subject, &sweep, load.tasks.size(), tasks.size()});
      load.tasks.insert(load.tasks.end(), tasks.begin(), tasks.end());
    }
  }
  return load;
}

void run_matrix(const std::vector<Case>& cases, const SuiteOptions& options, SuiteResult& result) {
  const Workload load = collect(cases, options);
  if (load.tasks.empty())
    throw InputError("nothing to run: no case asked for has the variant '" + options.variant +
                     "' in the tier '" + options.tier + "' (sandglass list cases)");
  std::vector<Outcome> outcomes(load.tasks.size());
  run_all(load.tasks, options, [&](std::size_t i) {
    outcomes[i] = run_task(load.tasks[i], options, i < load.matrix ? record_path(load.tasks[i]) : "");
    return outcomes[i].run.cpu_seconds;
  });
  for (const SweepRange& range : load.sweeps) {
    const auto first = outcomes.begin() + static_cast<std::ptrdiff_t>(range.first);
    result.sweeps.push_back(evaluate_sweep(*range.subject, *range.sweep,
                                           {first, first + static_cast<std::ptrdiff_t>(range.count)}));
  }
  outcomes.resize(load.matrix);
  result.outcomes = std::move(outcomes);
  write_verdicts(options.output, result.outcomes);
  for (const Case& subject : cases) write_evidence(options.output, subject, result.outcomes);
  write_sweeps(options.output, result.sweeps);
}

void run_mutants(const std::vector<Case>& cases, const SuiteOptions& options, SuiteResult& result) {
  std::vector<Task> tasks;
  std::vector<const Mutant*> mutants;
  for (const Case& subject : cases)
    for (const Mutant& mutant : subject.mutants) {
      if (!options.variant.empty() && mutant.variant != options.variant) continue;
      tasks.push_back(mutant_task(subject, options.tier, mutant));
      mutants.push_back(&mutant);
    }
  result.mutants.resize(tasks.size());
  run_all(tasks, options, [&](std::size_t i) {
    result.mutants[i] = judge_mutant(tasks[i], *mutants[i], options.confidence);
    return result.mutants[i].cpu_seconds;
  });
  write_mutants(options.output, result.mutants);
}

void run_keys(const std::vector<Case>& cases, const SuiteOptions& options, SuiteResult& result) {
  std::vector<Task> tasks;
  for (const Case& subject : cases)
    for (Task& task : expand(subject, options.tier, options.variant)) tasks.push_back(std::move(task));
  const auto finished = [&](std::size_t done, std::size_t total, const std::string& key) {
    if (options.progress)
      options.progress({done, total, static_cast<double>(done) / static_cast<double>(total), key, 0});
  };
  result.keys =
      try_keys(tasks, {options.jobs, options.confidence, options.known_keys, finished, options.stop});
  write_keys(options.output, result.keys);
}
}  // namespace

bool SuiteResult::blocked() const {
  const auto check_blocks = [](const CheckOutcome& check) { return blocks(check.judgement.verdict); };
  return std::any_of(outcomes.begin(), outcomes.end(),
                     [&](const Outcome& outcome) {
                       return std::any_of(outcome.checks.begin(), outcome.checks.end(), check_blocks);
                     }) ||
         std::any_of(mutants.begin(), mutants.end(),
                     [](const MutantResult& mutant) { return !mutant.caught; });
}

SuiteResult run_suite(const SuiteOptions& options) {
  SuiteResult result;
  result.cases = chosen_cases(options);
  if (options.mutants)
    run_mutants(result.cases, options, result);
  else if (options.keys)
    run_keys(result.cases, options, result);
  else
    run_matrix(result.cases, options, result);
  return result;
}

std::vector<CaseSummary> list_cases(const std::string& case_folder) {
  std::vector<CaseSummary> list;
  for (const Case& subject : read_cases(case_folder)) {
    CaseSummary summary{subject.name, subject.topic, subject.summary, {}, {}, subject.claims};
    for (const Variant& variant : subject.variants) summary.variants.push_back(variant.name);
    for (const Point& point : subject.points) summary.points.push_back(point.name);
    list.push_back(std::move(summary));
  }
  return list;
}

}  // namespace sandglass
