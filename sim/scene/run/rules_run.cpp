#include "sim/scene/rules.hpp"
#include "sim/scene/text/bounds.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::uint64_t largest_seed = std::numeric_limits<std::int64_t>::max();  // what TOML can hold
constexpr double most_steps = 9e15;  // below 2^53: a double counts every one of them

void check_cadence(Diagnostics& diagnostics, const std::string& path, const Cadence& cadence) {
  if (cadence.unit == Cadence::Unit::time)
    check_bounds(diagnostics, path + ".time", cadence.every, positive());
  if (cadence.unit == Cadence::Unit::collisions)
    check_bounds(diagnostics, path + ".collisions-per-particle", cadence.every, positive());
  if (cadence.unit != Cadence::Unit::steps) return;
  const std::string steps = path + ".steps";
  const bool in_bounds = check_bounds(diagnostics, steps, cadence.every, between(1, most_steps));
  if (in_bounds && cadence.every != std::floor(cadence.every))
    diagnostics.report(steps,
                       fmt::format("{} is {}; it must be a whole number", shown(steps), cadence.every));
}

void check_duration(Diagnostics& diagnostics, const Duration& duration) {
  const std::string path = "run.duration";
  const int given = duration.time.has_value() + duration.steps.has_value() + duration.collisions.has_value();
  if (given != 1 && diagnostics.clean(path))
    diagnostics.report(path,
                       "'run.duration' needs exactly one of 'time', 'steps' or 'collisions-per-particle'");
  if (duration.time) check_bounds(diagnostics, path + ".time", *duration.time, positive());
  if (duration.steps)
    check_bounds(diagnostics, path + ".steps", static_cast<double>(*duration.steps), between(1, most_steps));
  if (duration.collisions)
    check_bounds(diagnostics, path + ".collisions-per-particle", *duration.collisions, positive());
}

/// Of the duration, in a unit; infinite in another.
double given(const Duration& duration, Cadence::Unit unit) {
  if (unit == Cadence::Unit::time) return duration.time.value_or(HUGE_VAL);
  if (unit == Cadence::Unit::collisions) return duration.collisions.value_or(HUGE_VAL);
  return duration.steps ? static_cast<double>(*duration.steps) : HUGE_VAL;
}

/// Where both are given in the same unit.
void check_start(Diagnostics& diagnostics, const std::string& path, const Cadence& start,
                 const Duration& duration) {
  check_cadence(diagnostics, path, start);
  if (diagnostics.clean(path) && start.every > given(duration, start.unit))
    diagnostics.report(path, fmt::format("{} is {}, beyond 'run.duration', {}: nothing would be observed",
                                         shown(path), start.every, given(duration, start.unit)));
}
}  // namespace

void check_run(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.run.seed > largest_seed)
    diagnostics.report("run.seed",
                       fmt::format("'run.seed' is {}; at most {} is allowed", scene.run.seed, largest_seed));
  check_bounds(diagnostics, "run.replicas", static_cast<double>(scene.run.replicas), between(1, 1e6));
  check_duration(diagnostics, scene.run.duration);
  for (std::size_t i = 0; i < scene.observe.size(); ++i) {
    check_cadence(diagnostics, item_path("observe", i) + ".every", scene.observe[i].cadence);
    if (const auto& start = scene.observe[i].start)
      check_start(diagnostics, item_path("observe", i) + ".start", *start, scene.run.duration);
  }
  if (scene.output.trajectory) check_cadence(diagnostics, "output.trajectory", *scene.output.trajectory);
  if (scene.output.checkpoint) check_cadence(diagnostics, "output.checkpoint", *scene.output.checkpoint);
}

/// Where both are given in the same unit; the plan looks at what is left.
void check_steps(const Scene& scene, Diagnostics& diagnostics) {
  const Duration& duration = scene.run.duration;
  const TimeStep& step = scene.method.time_step;
  double steps = 1;
  if (duration.time && step.fixed) steps = *duration.time / *step.fixed;
  if (duration.collisions && step.collisions) steps = *duration.collisions / *step.collisions;
  if (steps > most_steps)
    diagnostics.report(
        "method.time-step",
        fmt::format("'method.time-step' makes {:.3g} steps of 'run.duration'; at most {:.0e} are "
                    "allowed: lengthen the one or shorten the other",
                    steps, most_steps));
  if (steps < 1)
    diagnostics.report(
        "method.time-step",
        fmt::format("'method.time-step' is {:.3g} times as long as 'run.duration': the first step "
                    "would run beyond the end; shorten it",
                    1 / steps));
}

}  // namespace sandglass
