#include "validation/suite/keys.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/suite/apart.hpp"
#include "validation/suite/outcome.hpp"
#include "validation/suite/pool.hpp"
#include "validation/suite/run_task.hpp"
#include "validation/suite/scene_keys.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace sandglass {

namespace {
constexpr std::size_t kCases = 6;

/// A run as the case wants it, made once for all keys that need it.
class HonestRun {
 public:
  HonestRun(const Task& task, const KeyOptions& options) : task_(&task), options_(&options) {}

  const Task& task() const { return *task_; }

  /// The first check that blocks when the method gets this scene instead, and not without.
  std::string moved_by(const Scene& scene) {
    std::call_once(done_, [this] { run(); });
    Record record;
    try {
      record = run_scene_apart(scene, run_options());
    } catch (const RunError&) {
      return "";  // a run that breaks is no verdict on the key
    }
    const auto lock = hold_off_new_processes();
    record.scene = scene_;
    const std::vector<CheckOutcome> checks = judge_record(*task_, record, options_->confidence);
    for (std::size_t i = 0; i < checks.size() && i < blocks_.size(); ++i)
      if (blocks(checks[i].judgement.verdict) && !blocks_[i]) return checks[i].evidence.check;
    return "";
  }

 private:
  RunOptions run_options() const {
    RunOptions run;
    run.stop = options_->stop;
    return run;
  }
  void run() {
    const Record record = run_scene_apart(task_->scene, run_options());
    const auto lock = hold_off_new_processes();
    scene_ = record.scene;
    for (const CheckOutcome& check : judge_record(*task_, record, options_->confidence))
      blocks_.push_back(blocks(check.judgement.verdict));
  }

  const Task* task_;
  const KeyOptions* options_;
  std::once_flag done_;
  std::string scene_;  ///< as resolved
  std::vector<bool> blocks_;
};

struct RunWithKey {
  HonestRun* run;
  double work;
};

/// The cheapest run of each case that says more than the default, the cheapest case first.
std::vector<HonestRun*> chosen(std::vector<RunWithKey> uses, const std::string& key) {
  std::ranges::stable_sort(uses, {}, &RunWithKey::work);
  std::vector<HonestRun*> runs;
  std::set<const Case*> cases;
  for (const RunWithKey& use : uses) {
    const Task& task = use.run->task();
    if (runs.size() == kCases) break;
    if (cases.contains(task.subject) || is_default(task.scene, key)) continue;
    cases.insert(task.subject);
    runs.push_back(use.run);
  }
  return runs;
}

void try_key(KeyResult& result, const std::vector<RunWithKey>& uses) {
  std::vector<HonestRun*> runs;
  {
    const auto lock = hold_off_new_processes();
    runs = chosen(uses, result.key);
    result.is_used = !runs.empty();
  }
  for (const auto change : {scaled_key, dropped_key})
    for (HonestRun* run : runs) {
      const Task& task = run->task();
      const std::optional<Miswired> miswired = [&] {
        const auto lock = hold_off_new_processes();
        return change(task.scene, result.key);
      }();
      if (!miswired) continue;
      result.trials.push_back(
          {task.subject->name, task.variant, task.point, miswired->how, run->moved_by(miswired->scene)});
      if (result.seen()) return;
    }
}

/// The key, or one within it: "domain.sides" is "domain.sides.x".
bool is_written(const std::string& key, const std::set<std::string>& written) {
  const auto found = written.lower_bound(key);
  return found != written.end() && (*found == key || found->starts_with(key + "."));
}
}  // namespace

std::vector<KeyResult> try_keys(const std::vector<Task>& tasks, const KeyOptions& options) {
  std::vector<std::unique_ptr<HonestRun>> runs;
  std::map<std::pair<std::string, std::string>, std::vector<RunWithKey>> uses;
  std::set<std::string> written;
  for (const Task& task : tasks) {
    runs.push_back(std::make_unique<HonestRun>(task, options));
    for (const std::string& key : method_keys(task.scene)) {
      uses[{key, method_family(task.scene)}].push_back({runs.back().get(), expected_work(task.scene)});
      written.insert(key);
    }
  }
  std::vector<KeyResult> results;
  std::vector<std::function<void()>> jobs;
  for (const auto& [name, runs_of_key] : uses) results.push_back({name.first, name.second, false, {}});
  std::mutex counting;
  std::size_t done = 0;
  for (KeyResult& result : results)
    jobs.emplace_back([&] {
      try_key(result, uses.at({result.key, result.family}));
      const std::lock_guard lock(counting);
      if (options.finished) options.finished(++done, results.size(), result.key + ", " + result.family);
    });
  run_in_parallel(options.jobs, jobs);
  for (const std::string& key : options.known)
    if (reaches_method(key) && !is_written(key, written)) results.push_back({key, "", false, {}});
  std::ranges::stable_sort(results, {}, &KeyResult::key);
  return results;
}

}  // namespace sandglass
