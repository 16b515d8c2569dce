#include "sim/base/error.hpp"
#include "sim/program/edited_scene.hpp"
#include "sim/program/folders.hpp"
#include "sim/program/options.hpp"
#include "sim/program/signals.hpp"
#include "validation/suite/suite.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

namespace sandglass::program {

namespace {

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

}  // namespace

int validate(const Options& options) {
  SuiteOptions suite = suite_options(options);
  suite.progress = reporter(options.quiet);
  const SuiteResult result = run_suite(suite);
  if (options.json) {
    print_file(suite.output + (options.mutants ? "/mutants.json" : "/verdicts.json"));
  } else if (!options.quiet) {
    print_verdicts(result);
    print_mutants(result);
  }
  return result.blocked() ? verdict_fails : all_well;
}

}  // namespace sandglass::program
