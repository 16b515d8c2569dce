#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/program/completion.hpp"
#include "sim/program/failure.hpp"
#include "sim/program/options.hpp"
#include "sim/program/parallel.hpp"

#include <cstdio>
#include <functional>
#include <map>

#include <CLI/CLI.hpp>

namespace sandglass::program {
namespace {

using Command = std::function<int(const Options&)>;

void add_settings(CLI::App& command, Options& options) {
  command
      .add_option("--set", options.settings,
                  "lay key=value over the scene, or over each one, as in --set species.restitution=0.9; may "
                  "be repeated")
      ->allow_extra_args(false);
}

void add_new(CLI::App& app, Options& options) {
  CLI::App* fresh = app.add_subcommand("new", "write a complete scene to start from");
  fresh->add_option("template", options.subject, "which one (sandglass list templates)")->required();
  fresh->add_option("-o,--output", options.output, "file to write (default: the template's name with .toml)");
  fresh->add_flag("--overwrite", options.overwrite, "replace a file that exists");
  fresh->add_flag("-q,--quiet", options.quiet, "print nothing but errors");
}

void add_help(CLI::App& app, Options& options) {
  app.add_subcommand("help", "what a scene may say")
      ->add_option("word", options.subject, "a section, a key, or section.key (default: all, in brief)");
}

void add_completion(CLI::App& app, Options& options) {
  app.add_subcommand("completion", "print a script that completes commands in a shell")
      ->add_option("shell", options.subject, "bash or zsh: source <(sandglass completion bash)")
      ->required();
}

void add_run(CLI::App& app, Options& options) {
  CLI::App* run = app.add_subcommand("run", "run a scene and write its record");
  run->add_option("scene", options.subject, "scene file (TOML)")->required();
  run->add_option("-o,--output", options.output,
                  "record to write (default: from the scene, else its name with .h5)");
  run->add_option("--seed", options.seed, "seed instead of the scene's");
  add_settings(*run, options);
  run->add_option("-j,--jobs", options.jobs, "replicas at a time, each on a core of its own (default: 1)")
      ->check(CLI::Range(1, 1024));
  run->add_flag("--overwrite", options.overwrite, "replace a record that exists");
  run->add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  CLI::App* resume = app.add_subcommand("resume", "go on from a checkpoint");
  resume->add_option("checkpoint", options.subject, "checkpoint file")->required();
  resume->add_option("-o,--output", options.output, "record to write (default: as the interrupted run)");
  resume
      ->add_option("--set", options.settings,
                   "change what cannot alter the past: run.duration, method.collapse-guard and its number, "
                   "observers, cadences of the output")
      ->allow_extra_args(false);
  resume->add_flag("--overwrite", options.overwrite, "replace a record that exists");
  resume->add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  CLI::App* plan = app.add_subcommand("plan", "say what a scene needs and what is left out");
  plan->add_option("scene", options.subject, "scene file (TOML)")->required();
  add_settings(*plan, options);
  plan->add_flag("--json", options.json, "as JSON");
}

void add_judging(CLI::App& app, Options& options) {
  CLI::App* check = app.add_subcommand("check", "hold a record against every law that applies");
  check->add_option("record", options.subject, "record (HDF5)")->required();
  check->add_flag("--json", options.json, "as JSON");
  CLI::App* validate = app.add_subcommand("validate", "run cases, judge them and write the report's data");
  validate->add_option("cases", options.words, "names of cases (default: all)");
  validate->add_option("--tier", options.tier, "smoke, standard or paper")->capture_default_str();
  validate->add_option("--variant", options.variant, "only this method variant");
  validate->add_option("-j,--jobs", options.jobs, "scenes at a time (default: one a core)");
  validate->add_option("-o,--output", options.output, "folder of the report (default: report)");
  add_settings(*validate, options);
  validate->add_option("--seed", options.seed, "fresh seeds drawn from this one");
  validate->add_flag("--mutants", options.mutants, "plant faults and demand that the checks catch them");
  validate
      ->add_flag("--keys", options.keys, "wire each scene key wrongly and list those that no verdict sees")
      ->excludes("--mutants");
  validate->add_flag("--json", options.json, "verdicts as JSON on standard output");
  validate->add_flag("-q,--quiet", options.quiet, "print nothing but errors");
}

void add_looking(CLI::App& app, Options& options) {
  CLI::App* list = app.add_subcommand(
      "list", "list templates, methods, observers, cases, laws, checks, claims or mutations");
  list->add_option("what", options.subject, "what to list")->required();
  list->add_flag("--json", options.json, "as JSON");
  CLI::App* law = app.add_subcommand("law", "evaluate an analytic result");
  law->add_option("name", options.subject, "name of the law (sandglass list laws)")->required();
  law->add_option("arguments", options.words, "key=value ...");
  law->add_flag("--json", options.json, "as JSON");
  CLI::App* files = app.add_subcommand("export", "write a record's trajectory for other programs");
  files->add_option("record", options.subject, "record (HDF5)")->required();
  files->add_option("--format", options.format, "vtp, xyz, mdanalysis or csv")->capture_default_str();
  files->add_option("-o,--output", options.output, "main file to write (default: the record's name)");
  files->add_flag("--overwrite", options.overwrite, "replace files that exist");
}

const std::map<std::string, Command>& commands() {
  static const std::map<std::string, Command> all = {
      {"help", help},           {"new", new_scene},      {"run", run},
      {"resume", resume_run},   {"plan", show_plan},     {"check", check},
      {"validate", validate},   {"list", list},          {"law", evaluate_law},
      {"export", export_files}, {"completion", nullptr},  // of what stands here
  };
  return all;
}

/// CLI11 would only say that the word was not expected.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> words;
  for (const auto& [word, command] : commands()) words.push_back(word);
  if (!commands().contains(argv[1])) throw InputError(unknown_word("command", argv[1], words));
}

int main_of(int argc, char** argv) {
  refuse_unknown_command(argc, argv);
  Options options;
  CLI::App app("Sandglass: granular flow, simulated and judged against what is known exactly", "sandglass");
  app.set_version_flag("--version", SANDGLASS_VERSION);
  app.require_subcommand(1);
  add_help(app, options);
  add_new(app, options);
  add_run(app, options);
  add_judging(app, options);
  add_looking(app, options);
  add_completion(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? all_well : bad_input;
  }
  options.command = app.get_subcommands().front()->get_name();
  if (options.command == "completion") {
    std::printf("%s", completion_script(app, options.subject).c_str());
    return all_well;
  }
  const Parallel parallel;
  options.ranks = parallel.ranks();
  try {
    parallel.require_work(options.command);
    return commands().at(options.command)(options);
  } catch (...) {
    return parallel.report(current_failure());
  }
}

}  // namespace
}  // namespace sandglass::program

int main(int argc, char** argv) {
  using namespace sandglass::program;
  try {
    return main_of(argc, argv);
  } catch (...) {
    const Failure failure = current_failure();
    std::fprintf(stderr, "%s\n", failure.words.c_str());
    return failure.code;
  }
}
