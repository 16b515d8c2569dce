#include "sim/run/run.hpp"

#include "sim/base/error.hpp"
#include "sim/program/options.hpp"
#include "sim/program/progress_line.hpp"
#include "sim/program/signals.hpp"
#include "sim/program/table.hpp"
#include "sim/record/atomic_file.hpp"
#include "sim/record/record.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace sandglass::program {

namespace {

std::string record_path(const Options& options, const Scene& scene) {
  if (!options.output.empty()) return options.output;
  if (!scene.output.record.empty()) return scene.output.record;
  return std::filesystem::path(options.subject).stem().replace_extension(".h5").string();
}

std::string checkpoint_path(const std::string& record) {
  return std::filesystem::path(record).replace_extension(".checkpoint.h5").string();
}

/// A run of hours must not end at a folder that is not there.
void refuse_bad_path(const std::string& path, bool overwrite) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder, none))
    throw InputError(fmt::format("{}: no such folder: {}; make it, or give another place with --output", path,
                                 folder.string()));
  if (fs::is_directory(path, none))
    throw InputError(fmt::format("{}: is a folder; give a file with --output", path));
  if (!overwrite && fs::exists(path, none))
    throw InputError(fmt::format(
        "{}: exists already; use --overwrite to replace it, or another file with --output", path));
  require_writable(path);
}

std::string summary(const Record& record, const std::string& path) {
  double moves = 0, collisions = 0;
  for (const Replica& replica : record.replicas) {
    moves += replica.counters.at("particle-moves");
    collisions += replica.counters.at("collisions");
  }
  const double seconds = record.timings.at("cpu-seconds");
  std::string text = fmt::format(
      "{}: {} replica(s), {:.4g} collisions, {:.4g} particle-moves in {:.3g} CPU seconds ({:.3g} moves/s)\n",
      path, record.replicas.size(), collisions, moves, seconds, moves / seconds);
  std::vector<std::vector<std::string>> rows = {{"quantity", "mean", "standard error", "units"}};
  for (const Estimate& estimate : record.estimates) {
    if (estimate.value.size() > 8) continue;
    for (std::size_t i = 0; i < estimate.value.size(); ++i) {
      const auto& names = estimate.quantity.components;
      rows.push_back({estimate.quantity.name + (i < names.size() ? " " + names[i] : ""),
                      fmt::format("{:.6g}", estimate.value[i]),
                      fmt::format("{:.2g}", estimate.standard_error[i]), estimate.quantity.units});
    }
  }
  return text + columns(rows);
}

/// Runs `work`, which returns the record, with signals caught and progress shown, and writes the record.
template <class Work>
int run_to_record(const Options& options, const std::string& path, Work work) {
  refuse_bad_path(path, options.overwrite);
  ProgressLine line(options.quiet);
  RunOptions run_options;
  run_options.checkpoint_path = checkpoint_path(path);
  run_options.progress = line.callback();
  run_options.stop = &stop_on_signal();
  try {
    const Record record = work(run_options);
    write_record(path, record);
    if (!options.quiet) fmt::print("{}", summary(record, path));
  } catch (const Interrupted& stop) {
    throw Interrupted(
        fmt::format("{}; go on with: sandglass resume {}", stop.what(), run_options.checkpoint_path));
  }
  return all_well;
}

/// What the plan of the scene warns of, on the error stream, so that nobody has to ask for the plan to see it.
void warn(const Scene& scene) {
  for (const std::string& warning : plan(scene).warnings) fmt::print(stderr, "warning: {}\n", warning);
}

}  // namespace

int run(const Options& options) {
  Scene scene = read_scene_file(options.subject);
  if (!options.quiet) warn(scene);
  if (options.seed) scene.run.seed = *options.seed;
  const std::string path = record_path(options, scene);
  scene.output.record = path;
  return run_to_record(options, path,
                       [&](const RunOptions& run_options) { return run_scene(scene, run_options); });
}

int resume_run(const Options& options) {
  const Record checkpoint = read_record(options.subject);
  if (!checkpoint.state)
    throw InputError(fmt::format("{}: is a finished record, not a checkpoint; there is nothing to resume",
                                 options.subject));
  const Scene scene = read_scene_text(checkpoint.scene, options.subject);
  const std::string path = record_path(options, scene);
  return run_to_record(options, path,
                       [&](const RunOptions& run_options) { return resume(checkpoint, run_options); });
}

}  // namespace sandglass::program
