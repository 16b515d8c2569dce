#include "sim/run/run.hpp"

#include "sim/base/error.hpp"
#include "sim/base/steady.hpp"
#include "sim/base/thread_ranks.hpp"
#include "sim/program/edited_scene.hpp"
#include "sim/program/failure.hpp"
#include "sim/program/memory.hpp"
#include "sim/program/options.hpp"
#include "sim/program/progress_line.hpp"
#include "sim/program/signals.hpp"
#include "sim/program/table.hpp"
#include "sim/record/output_files.hpp"
#include "sim/record/record.hpp"
#include "sim/run/change_scene.hpp"
#include "sim/run/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace sandglass::program {

namespace {

std::string record_path(const Options& options, const Scene& scene) {
  if (!options.output.empty()) return options.output;
  if (!scene.output.record.empty()) return scene.output.record;
  return std::filesystem::path(options.subject).stem().string() + ".h5";
}

std::string checkpoint_path(const std::string& record) {
  return (record.ends_with(".h5") ? record.substr(0, record.size() - 3) : record) + ".checkpoint.h5";
}

/// What a reader must know of a mean before trusting it.
std::string remark(const Estimate& estimate, std::size_t component, std::size_t replicas) {
  constexpr double few = 10;
  if (estimate.drifts) return "drifts: no steady mean";
  if (replicas > 1 || estimate.effective_samples >= few) return "";
  const double error = estimate.standard_error[component];
  if (error <= rounding_share * std::abs(estimate.value[component])) return "";  // constant
  return fmt::format("{:.0f} independent samples", estimate.effective_samples);
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
  std::vector<std::vector<std::string>> rows = {
      {"quantity", "mean", "standard error", "units", "since time", ""}};
  for (const Estimate& estimate : record.estimates) {
    if (estimate.value.size() > 8) continue;
    for (std::size_t i = 0; i < estimate.value.size(); ++i) {
      const auto& names = estimate.quantity.components;
      rows.push_back({estimate.quantity.name + (i < names.size() ? " " + names[i] : ""),
                      fmt::format("{:.6g}", estimate.value[i]),
                      fmt::format("{:.2g}", estimate.standard_error[i]), estimate.quantity.units,
                      fmt::format("{:.4g}", estimate.start_time),
                      remark(estimate, i, record.replicas.size())});
    }
  }
  return text + columns(rows);
}

/// Claims a file of the run and says which leftovers of killed runs went.
void claim(OutputFiles& outputs, const Options& options, OutputFile output) {
  if (options.overwrite) output.existing = Existing::replace;
  for (const std::string& part : outputs.claim(output))
    if (!options.quiet) fmt::print(stderr, "removed what a killed run left over: {}\n", part);
}

/// The record, the checkpoints beside it and the trace of events. What is resumed is replaced by what follows it.
void claim_files(OutputFiles& outputs, const Options& options, const Scene& scene,
                 const std::string& record) {
  const bool resumes = options.command == "resume";
  const std::string checkpoint = checkpoint_path(record);
  claim(outputs, options,
        {record, Existing::keep, "use --overwrite to replace it, or another file with --output"});
  claim(outputs, options,
        {checkpoint, resumes && checkpoint == options.subject ? Existing::replace : Existing::keep,
         fmt::format("go on with 'sandglass resume {}', or use --overwrite to start anew", checkpoint)});
  if (scene.output.event_trace)
    claim(outputs, options,
          {*scene.output.event_trace, resumes ? Existing::replace : Existing::keep,
           "use --overwrite to replace it, or name another file in 'output.event-trace'"});
}

/// The record stands: its checkpoint has served. What appeared at the record's place during the run is kept.
void finish(const Options& options, const Record& record, const std::string& path) {
  const Existing existing = options.overwrite ? Existing::replace : Existing::keep;
  const std::string written = write_record(path, record, existing);
  std::error_code none;
  std::filesystem::remove(checkpoint_path(path), none);
  if (written != path)
    fmt::print(stderr, "warning: {} appeared during the run; the record is {}\n", path, written);
  if (!options.quiet) fmt::print("{}", summary(record, written));
}

/// Of the ranks that share the work the first speaks and writes.
bool is_first(const Options& options) { return options.ranks == nullptr || options.ranks->is_first(); }
bool is_quiet(const Options& options) { return options.quiet || !is_first(options); }

std::string broken_path(const std::string& record) {
  return (record.ends_with(".h5") ? record.substr(0, record.size() - 3) : record) + ".broken.h5";
}

/// From where a run that has ended early can go on.
std::string way_on(const std::string& checkpoint) {
  std::error_code none;
  if (std::filesystem::exists(checkpoint, none))
    return fmt::format("go on from the last checkpoint with: sandglass resume {}", checkpoint);
  return "there is no checkpoint to go on from; 'output.checkpoint' in the scene asks for some";
}

/// How a run ended that has not come to its end; `kept` names the file of what it has, if any.
Failure early_end(const Options& options, const std::string& checkpoint, const std::string& kept) {
  Failure failure = current_failure();
  if (failure.words.empty()) return failure;
  if (!kept.empty())
    failure.words += fmt::format("\nwhat the run has so far is kept in {}, marked as broken", kept);
  if (!failure.everywhere && (options.ranks != nullptr || options.jobs > 1))
    failure.words += "; replicas that run side by side leave no checkpoint";
  else
    failure.words += fmt::format("\n{}", way_on(checkpoint));
  return failure;
}

/// Runs `work`, which returns the record, with signals caught and progress shown, and writes the record.
template <class Work>
int run_to_record(const Options& options, const Scene& scene, const std::string& path, Work work) {
  const bool replaces_input = checkpoint_path(path) == options.subject;
  OutputFiles outputs(replaces_input ? std::vector<std::string>{} : std::vector{options.subject});
  together(options.ranks, [&] {
    if (is_first(options)) claim_files(outputs, options, scene, path);
    return true;
  });
  ProgressLine line(is_quiet(options));
  RunOptions run_options;
  run_options.checkpoint_path = checkpoint_path(path);
  run_options.progress = line.callback();
  run_options.stop = &stop_on_signal(is_quiet(options));
  run_options.ranks = options.ranks;
  std::string kept;
  run_options.keep_broken = [&](const Record& broken) {
    kept = write_record(broken_path(path), broken, options.overwrite ? Existing::replace : Existing::keep);
  };
  std::optional<Record> record;
  try {
    record = work(run_options);
  } catch (const Interrupted& stop) {
    Failure failure = early_end(options, run_options.checkpoint_path, kept);
    if (stop.everywhere() && !is_first(options)) failure.words.clear();
    throw failure;
  } catch (const std::exception&) {
    if (kept.empty()) throw;
    throw early_end(options, run_options.checkpoint_path, kept);
  }
  if (is_first(options)) finish(options, *record, path);
  return all_well;
}

/// What the plan of the scene warns of, on the error stream, so that nobody has to ask for the plan to see it. Throws
/// InputError when the machine cannot hold the particles, or when ranks cannot share the work.
void heed_plan(const Scene& scene, const Options& options) {
  const Plan planned = plan(scene);
  if (options.ranks != nullptr) sharing_of(scene, options.ranks->count(), false);
  if (exceeds_memory(planned))
    throw InputError(
        fmt::format("{} particles do not fit into memory: {}; take fewer, or a larger "
                    "'method.weight' where the method has one",
                    planned.particles, memory_words(planned)));
  for (const std::string& warning : planned.warnings)
    if (!is_quiet(options)) fmt::print(stderr, "warning: {}\n", warning);
}

Record read_checkpoint(const Options& options) {
  Record checkpoint = read_record(options.subject);
  if (!checkpoint.state)
    throw InputError(fmt::format("{}: is a finished record, not a checkpoint; there is nothing to resume",
                                 options.subject));
  if (!options.settings.empty()) {
    const Scene changed = edited_scene(checkpoint.scene, options.subject, options.settings);
    std::vector<std::string> words;
    for (const std::string& setting : options.settings) words.push_back(fmt::format("--set {}", setting));
    change_scene(checkpoint, changed, words);
  }
  const Scene scene = read_scene_text(checkpoint.scene, options.subject);
  if (options.ranks != nullptr) sharing_of(scene, options.ranks->count(), true);
  return checkpoint;
}

/// Replicas on threads, which share them as ranks do: the record is that of one.
Record run_side_by_side(const Scene& scene, const RunOptions& options, int jobs) {
  if (options.ranks != nullptr)
    throw InputError(
        "-j runs replicas on threads of one process: leave it out under mpirun, which shares them too");
  if (scene.output.checkpoint)
    throw InputError(
        "-j runs replicas side by side, and a checkpoint holds one of them: leave out -j or "
        "'output.checkpoint'");
  const auto threads = std::min(scene.run.replicas, static_cast<std::uint64_t>(jobs));
  Record record;
  on_ranks(threads, [&](Communicator& ranks) {
    RunOptions own = options;
    own.ranks = &ranks;
    if (!ranks.is_first()) own.progress = {};
    Record result = run_scene(scene, own);
    if (ranks.is_first()) record = std::move(result);
  });
  return record;
}

}  // namespace

int run(const Options& options) {
  Scene scene = together(options.ranks, [&] {
    Scene read = read_edited_scene(options.subject, options.settings);
    heed_plan(read, options);
    return read;
  });
  if (options.seed) scene.run.seed = *options.seed;
  const std::string path = record_path(options, scene);
  scene.output.record = path;
  return run_to_record(options, scene, path, [&](const RunOptions& run_options) {
    return options.jobs > 1 ? run_side_by_side(scene, run_options, options.jobs)
                            : run_scene(scene, run_options);
  });
}

int resume_run(const Options& options) {
  const Record checkpoint = together(options.ranks, [&] { return read_checkpoint(options); });
  const Scene scene = read_scene_text(checkpoint.scene, options.subject);
  const std::string path = record_path(options, scene);
  return run_to_record(options, scene, path,
                       [&](const RunOptions& run_options) { return resume(checkpoint, run_options); });
}

}  // namespace sandglass::program
