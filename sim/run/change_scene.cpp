#include "sim/run/change_scene.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/guard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandglass {

namespace {
/// The changed scene, with what may differ as it was.
Scene with_free_parts_of(Scene scene, const Scene& before) {
  scene.title = before.title;
  scene.run.duration = before.run.duration;
  scene.observe = before.observe;
  scene.output.record = before.output.record;
  scene.output.trajectory = before.output.trajectory;
  scene.output.checkpoint = before.output.checkpoint;
  set_guard(scene.method, guard_of(before.method));
  return scene;
}

void refuse_other_past(const Scene& before, const Scene& scene) {
  const Scene after = with_free_parts_of(scene, before);
  std::vector<std::string> sections;
  const auto compare = [&](const char* section, bool same) {
    if (!same) sections.emplace_back(section);
  };
  compare("run", after.run == before.run);
  compare("domain", after.domain == before.domain);
  compare("species", after.species == before.species);
  compare("method", after.method == before.method);
  compare("output", after.output == before.output);
  if (after != before && sections.empty()) sections.emplace_back("the scene");
  if (sections.empty()) return;
  throw InputError(fmt::format(
      "what has shaped the past of a run cannot change when it is resumed, and in [{}] it would; free are "
      "'run.duration', the collapse guard of 'method', [[observe]], 'output.trajectory' and "
      "'output.checkpoint': run the changed scene from the start",
      fmt::join(sections, "], [")));
}

/// Replicas that are done have lasted so long, and have been observed so.
void refuse_unlike_replicas(const Record& checkpoint, const Scene& before, const Scene& scene) {
  if (checkpoint.replicas.empty()) return;
  if (scene.run.duration == before.run.duration && scene.observe == before.observe) return;
  throw InputError(fmt::format(
      "{} of the replicas {} done: neither 'run.duration' nor [[observe]] can change for those that are left",
      checkpoint.replicas.size(), checkpoint.replicas.size() == 1 ? "is" : "are"));
}

void refuse_end_in_the_past(const State& state, const Duration& duration) {
  const bool past =
      (duration.time && *duration.time < state.time) || (duration.steps && *duration.steps < state.step);
  if (past)
    throw InputError(fmt::format("the run has come to step {}, time {:.6g}: 'run.duration' must end later",
                                 state.step, state.time));
}
}  // namespace

void change_scene(Record& checkpoint, const Scene& changed, const std::vector<std::string>& words) {
  const Scene before = read_scene_text(checkpoint.scene, "scene of the checkpoint");
  State& state = checkpoint.state.value();
  refuse_other_past(before, changed);
  refuse_unlike_replicas(checkpoint, before, changed);
  refuse_end_in_the_past(state, changed.run.duration);
  checkpoint.scene = write_scene(changed);
  state.changed = true;
  for (const std::string& word : words)
    checkpoint.changes.push_back(fmt::format("{}, from step {}, time {:.6g} of replica {}", word, state.step,
                                             state.time, checkpoint.replicas.size() + 1));
}

}  // namespace sandglass
