#include "sim/base/error.hpp"
#include "sim/program/edited_scene.hpp"
#include "sim/program/folders.hpp"
#include "sim/program/options.hpp"
#include "sim/program/scene_page.hpp"
#include "sim/program/signals.hpp"
#include "validation/suite/suite.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

namespace sandglass::program {

namespace {

/// "section.key" of every table of a scene.
std::vector<std::string> known_keys() {
  std::vector<std::string> keys;
  for (const PageSection& section : read_scene_page(scene_page())) {
    if (std::islower(static_cast<unsigned char>(section.name.front())) == 0) continue;  // no table
    for (const KeyEntry& entry : section.keys) keys.push_back(section.name + "." + entry.key);
  }
  return keys;
}

SuiteOptions suite_options(const Options& options) {
  SuiteOptions suite;
  suite.case_folder = case_folder();
  suite.cases = options.words;
  suite.tier = options.tier;
  suite.variant = options.variant;
  suite.jobs = options.jobs > 0 ? static_cast<unsigned>(options.jobs)
                                : std::max(1u, std::thread::hardware_concurrency());
  if (!options.output.empty()) suite.output = options.output;
  suite.mutants = options.mutants;
  suite.keys = options.keys;
  if (options.keys) suite.known_keys = known_keys();
  suite.seed = options.seed;
  suite.settings = overrides_of(options.settings);
  suite.stop = &stop_on_signal(options.quiet);
  return suite;
}

/// A live line on a terminal, a line per finished run elsewhere.
std::function<void(const SuiteProgress&)> reporter(bool quiet) {
  if (quiet) return {};
  const bool live = isatty(STDERR_FILENO) != 0;
  return [live](const SuiteProgress& progress) {
    fmt::print(stderr, "{}[{}/{}] {:3.0f}%  {}  {:.2f} CPU s{}", live ? "\r\033[K" : "", progress.done,
               progress.total, 100 * progress.fraction, progress.finished, progress.cpu_seconds,
               live ? "" : "\n");
    if (live && progress.done == progress.total) fmt::print(stderr, "\r\033[K");
  };
}

void print_blocking(const Outcome& outcome, const CheckOutcome& check) {
  if (blocks(check.judgement.verdict))
    fmt::print("{}  {}/{}/{}  {}: {}\n", to_string(check.judgement.verdict), outcome.case_name,
               outcome.run.variant, outcome.run.point, check.evidence.check, check.judgement.reason);
}

void print_verdicts(const SuiteResult& result) {
  std::map<std::string, int> count;
  for (const Outcome& outcome : result.outcomes)
    for (const CheckOutcome& check : outcome.checks) {
      ++count[to_string(check.judgement.verdict)];
      print_blocking(outcome, check);
    }
  std::string text;
  for (const auto& [word, number] : count)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, word);
  if (!text.empty()) fmt::print("verdicts: {}\n", text);
}

void print_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw RunError("cannot read '" + path + "' back");
  std::cout << file.rdbuf();
}

void print_mutants(const SuiteResult& result) {
  if (result.mutants.empty()) return;
  const auto caught =
      std::ranges::count_if(result.mutants, [](const MutantResult& mutant) { return mutant.caught; });
  for (const MutantResult& mutant : result.mutants)
    if (!mutant.caught)
      fmt::print("missed  {} by {}/{}/{}  {}: {}\n", mutant.fault, mutant.case_name, mutant.variant,
                 mutant.point, mutant.check.evidence.check, mutant.check.judgement.reason);
  fmt::print("planted faults: {} of {} caught\n", caught, result.mutants.size());
}

std::string trials_text(const KeyResult& key) {
  if (key.family.empty()) return "no case has it in this tier";
  if (!key.is_used) return "nothing but its default";
  if (key.trials.empty()) return "cannot be changed alone";
  std::string text;
  for (const KeyTrial& trial : key.trials)
    text += fmt::format("{}{} in {}/{}/{}", text.empty() ? "" : ", ", trial.how, trial.case_name,
                        trial.variant, trial.point);
  return text;
}

void print_keys(const SuiteResult& result) {
  if (result.keys.empty()) return;
  for (const KeyResult& key : result.keys)
    if (!key.seen()) fmt::print("unseen  {}  {}: {}\n", key.key, key.family, trials_text(key));
  fmt::print("keys that a verdict sees: {} of {}\n", std::ranges::count_if(result.keys, &KeyResult::seen),
             result.keys.size());
}

std::string json_file(const Options& options) {
  return options.mutants ? "mutants.json" : options.keys ? "keys.json" : "verdicts.json";
}
}  // namespace

int validate(const Options& options) {
  SuiteOptions suite = suite_options(options);
  suite.progress = reporter(options.quiet);
  const SuiteResult result = run_suite(suite);
  if (options.json) {
    print_file(suite.output + "/" + json_file(options));
  } else if (!options.quiet) {
    print_verdicts(result);
    print_mutants(result);
    print_keys(result);
  }
  return result.blocked() ? verdict_fails : all_well;
}

}  // namespace sandglass::program
