#pragma once

#include "sim/base/communicator.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sandglass::program {

/// The command line, read. Which fields mean something depends on the command.
struct Options {
  std::string command;
  std::string subject;             ///< scene, record, checkpoint, name of a law, or what to list
  std::vector<std::string> words;  ///< key=value pairs of a law, or cases
  std::string output;
  std::string format = "vtp";
  std::string tier = "standard";
  std::string variant;
  std::vector<std::string> settings;  ///< key=value pairs laid over a scene
  std::optional<std::uint64_t> seed;
  Communicator* ranks = nullptr;  ///< share the work; null: this process alone
  int jobs = 0;                   ///< 0: as many as there are cores
  bool json = false, quiet = false, overwrite = false, mutants = false, keys = false;
};

/// Exit codes of every command.
enum Exit : int { all_well = 0, verdict_fails = 1, bad_input = 2, run_broke = 3 };

int list(const Options& options);
int help(const Options& options);
int new_scene(const Options& options);
int evaluate_law(const Options& options);
int show_plan(const Options& options);
int run(const Options& options);
int resume_run(const Options& options);
int check(const Options& options);
int export_files(const Options& options);
int validate(const Options& options);

}  // namespace sandglass::program
