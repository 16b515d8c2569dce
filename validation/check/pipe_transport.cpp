#include "sim/base/error.hpp"
#include "validation/check/families.hpp"
#include "validation/check/pipe.hpp"
#include "validation/check/wave_speed.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// What a pipe carries and how fast: speed of its density waves, flow rate against area fraction.

namespace sandglass {

namespace {
SpaceTime space_time(const PipeSlices& run) { return {run.count, run.slices, run.thickness, run.interval}; }

/// Means of `together` samples in a row, which a pattern that blinks from step to step leaves no trace in.
PipeSlices in_groups(const PipeSlices& run, std::size_t together) {
  PipeSlices groups{{}, run.slices, run.thickness, run.interval * static_cast<double>(together)};
  groups.count.assign(run.samples() / together * run.slices, 0.0);
  for (std::size_t i = 0; i < groups.count.size() * together; ++i)
    groups.count[i / (together * run.slices) * run.slices + i % run.slices] +=
        run.count[i] / static_cast<double>(together);
  return groups;
}

/// Speed that waves are compared with, upwards: a given one along gravity, or that of the stream.
double compared_speed(const Subject& subject, const law::Arguments& numbers) {
  if (numbers.at("over") > 0) return numbers.at("over") * sign_of_gravity(subject.scene());
  double stream = 0;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    stream += stream_velocity(subject, replica, numbers.at("settle-time"));
  return stream / static_cast<double>(subject.replicas());
}

Mean speed_of_waves(const Subject& subject, const law::Arguments& numbers) {
  const auto number = [&](const char* name) { return static_cast<std::size_t>(numbers.at(name)); };
  std::vector<PipeSlices> slices;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    slices.push_back(in_groups(pipe_slices(subject, replica, numbers.at("settle-time"), number("slices")),
                               number("together")));
  std::vector<SpaceTime> runs;
  for (const PipeSlices& run : slices) runs.push_back(space_time(run));
  return runs.size() > 1 ? wave_speed(runs, number("lags")) : wave_speed(runs.front(), number("lags"), 4);
}

Evidence pipe_wave_speed(const Subject& subject, const law::Arguments& numbers) {
  const double other = compared_speed(subject, numbers);
  Mean speed = speed_of_waves(subject, numbers);
  speed.value /= other;
  speed.standard_error /= std::abs(other);
  Evidence evidence = from_mean(speed, numbers.at("least"));
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("most");
  evidence.budget.reference = evidence.value * numbers.at("over-error");
  evidence.budget.systematic = 0.05 * std::abs(evidence.value);
  evidence.budget.reason = "the parabola through three slices";
  return evidence;
}

/// Area fraction times mean velocity along gravity, from passages of a plane across the pipe: where moves are refused
/// particles keep a velocity with which they do not move, and the momentum is not the flow.
double flow_rate(const Subject& subject, std::size_t replica, double from) {
  const std::vector<double>& time = subject.series(replica, "crossing-count").time;
  const auto first = std::lower_bound(time.begin(), time.end(), from) - time.begin();
  if (static_cast<std::size_t>(first) + 1 >= time.size())
    throw InputError("fewer than 2 samples of 'crossings' after 'settle-time': run longer, or lower it");
  const auto passed = [&](const std::string& way) {
    const std::vector<double> count = subject.column(replica, "crossing-count", way);
    return count.back() - count[static_cast<std::size_t>(first)];
  };
  const Scene& scene = subject.scene();
  const double net = (passed("up") - passed("down")) * sign_of_gravity(scene) * scene.method.weight;
  const double across = volume(scene.domain) / scene.domain.size[static_cast<std::size_t>(pipe_axis(scene))];
  return net / (time.back() - time[static_cast<std::size_t>(first)]) / across *
         law::particle_volume(subject.gas(1));
}

/// Slope of ln(flow rate) against ln(area fraction), from a reference to this run.
Evidence pipe_flow_growth(const Subject& subject, const law::Arguments& numbers) {
  std::vector<double> rates;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    rates.push_back(flow_rate(subject, replica, numbers.at("settle-time")));
  const Mean rate = mean_of_independent(rates);
  const double step = std::log(subject.gas(1).fraction / numbers.at("fraction"));
  Evidence evidence = from_mean(rate, numbers.at("least"));
  evidence.value = std::log(rate.value / numbers.at("rate")) / step;
  evidence.standard_error = rate.standard_error / rate.value / std::abs(step);
  evidence.budget.reference = numbers.at("rate-error") / numbers.at("rate") / std::abs(step);
  evidence.kind = Expectation::between;
  evidence.upper = numbers.at("most");
  evidence.summary = fmt::format(
      "flow rate {:.4g} ± {:.2g} at area fraction {:.3g}: growth from {:.4g} at {:.3g}", rate.value,
      rate.standard_error, subject.gas(1).fraction, numbers.at("rate"), numbers.at("fraction"));
  return evidence;
}

bool crosses_pipe(const Scene& scene) {
  return is_falling_pipe(scene) &&
         std::any_of(scene.observe.begin(), scene.observe.end(), [&](const Observe& observe) {
           return observe.what == "crossings" && observe.axis == pipe_axis(scene);
         });
}

law::Parameter settle() { return {"settle-time", "time", "samples before it are left out", 0, 1e12, 0.0}; }
}  // namespace

std::vector<CheckInfo> pipe_transport_checks() {
  CheckInfo speed{
      "pipe-wave-speed",
      "speed of the density waves of a pipe over the mean velocity of its particles, or over a given one",
      "",
      {"fields", "momentum"},
      false,
      {settle(),
       {"slices", "1", "slices along the pipe; 0: all bins", 0, 1e6, 0.0},
       {"lags", "samples", "longest lag of the correlation", 1, 1e4, 4.0},
       {"over", "velocity", "speed along gravity to divide by; 0: of the stream", 0, 1e12, 0.0},
       {"over-error", "1", "relative standard error of that speed", 0, 1, 0.0},
       {"together", "samples", "samples in a row that are averaged first", 1, 1e4, 1.0, 1},
       {"least", "1", "lower bound of the ratio", -10, 10},
       {"most", "1", "upper bound of the ratio", -10, 10}},
      is_falling_pipe,
      pipe_wave_speed};
  CheckInfo growth{
      "pipe-flow-growth",
      "exponent with which the flow rate of a pipe grows with the area fraction, from a reference to the run",
      "",
      {"crossing-count"},
      false,
      {settle(),
       {"fraction", "1", "area fraction of the reference", 1e-6, 1},
       {"rate", "velocity", "its flow rate: area fraction times mean velocity", 1e-12, 1e12},
       {"rate-error", "velocity", "standard error of that rate", 0, 1e12},
       {"least", "1", "lower bound of the exponent", -100, 100},
       {"most", "1", "upper bound of the exponent", -100, 100}},
      crosses_pipe,
      pipe_flow_growth};
  return {std::move(speed), std::move(growth)};
}

}  // namespace sandglass
