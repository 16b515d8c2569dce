#include "validation/suite/sweep.hpp"

#include <cmath>
#include <limits>

namespace sandglass {

namespace {
constexpr double clear_of_noise = 2;  // standard errors

Task task_of(const Case& subject, const std::string& tier, const Sweep& sweep, const Override& set,
             const std::string& name) {
  Task task{&subject,
            sweep.variant,
            sweep.point,
            scene_of(subject, tier, sweep.variant, sweep.point, set),
            {&sweep.use}};
  task.scene.run.seed = derived_seed(task.scene.run.seed, sweep.knob + "/" + name);
  return task;
}

/// The knob "replicas" changes the error bar and nothing else.
bool follows_error_bar(const Sweep& sweep) { return sweep.knob == "replicas"; }

SweepValue value_of(const Outcome& outcome, double knob, const SweepResult& result) {
  const Evidence& evidence = outcome.checks.front().evidence;
  SweepValue value{knob, evidence.value,          evidence.standard_error,
                   0,    outcome.run.cpu_seconds, outcome.run.work};
  value.error =
      follows_error_bar(*result.sweep) ? value.standard_error : std::abs(value.value - result.reference);
  return value;
}

/// Standard error of the error itself. That of a standard error from R replicas is a part 1/sqrt(2(R-1)) of
/// it.
double noise_of(const SweepValue& value, const SweepResult& result) {
  if (follows_error_bar(*result.sweep)) return value.error / std::sqrt(2 * std::max(1.0, value.knob - 1));
  return std::hypot(value.standard_error, result.reference_error);
}

void fit_order(SweepResult& result) {
  std::vector<double> x, y, errors;
  for (const SweepValue& value : result.points) {
    const double noise = noise_of(value, result);
    if (!(value.error > clear_of_noise * noise) && !follows_error_bar(*result.sweep)) continue;
    x.push_back(std::log(value.knob));
    y.push_back(std::log(value.error));
    errors.push_back(noise / value.error);
  }
  result.order = result.order_error = std::numeric_limits<double>::quiet_NaN();
  result.order_reason = "fewer than two points have an error above 2 standard errors";
  if (x.size() < 2) return;
  const LineFit fit = fit_line(x, y, errors);
  result.order = fit.slope;
  result.order_error = fit.slope_error;
  result.order_reason =
      "weighted fit of log error against log knob over points with error > 2 standard errors";
}
}  // namespace

std::vector<Task> sweep_tasks(const Case& subject, const std::string& tier, const Sweep& sweep) {
  std::vector<Task> tasks{task_of(subject, tier, sweep, sweep.reference, "reference")};
  for (const SweepPoint& point : sweep.points)
    tasks.push_back(task_of(subject, tier, sweep, point.set, std::to_string(point.knob)));
  return tasks;
}

SweepResult evaluate_sweep(const Case& subject, const Sweep& sweep, const std::vector<Outcome>& outcomes) {
  SweepResult result;
  result.case_name = subject.name;
  result.sweep = &sweep;
  const Evidence& reference = outcomes.front().checks.front().evidence;
  result.units = reference.units;
  result.reference = reference.value;
  result.reference_error = reference.standard_error;
  for (std::size_t i = 0; i < sweep.points.size(); ++i)
    result.points.push_back(value_of(outcomes.at(i + 1), sweep.points[i].knob, result));
  fit_order(result);
  return result;
}

}  // namespace sandglass
