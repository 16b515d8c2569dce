#include "sim/method/collision_rate.hpp"
#include "sim/observe/axes.hpp"
#include "sim/run/setup.hpp"
#include "sim/scene/method/family.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

/// Of a Maxwellian gas the fastest of a million particles moves at about five thermal speeds.
template <int D>
double expected_step(const Setup<D>& setup, double rate) {
  const TimeStep& step = setup.scene.method.time_step;
  if (step.fixed) return *step.fixed;
  if (step.collisions) return *step.collisions / rate;
  return *step.cell_fraction * setup.method->cell_edge() / (10 * thermal_speed(setup.scene));
}

/// Steps and collisions that the duration stands for, at the initial temperature.
template <int D>
void expect_work(const Setup<D>& setup, Plan& plan) {
  const Scene& scene = setup.scene;
  const double rate = setup.method->collision_rate(scene.initial.temperature);
  plan.mean_free_path = mean_speed(D, thermal_speed(scene)) / rate;
  plan.time_step = expected_step(setup, rate);
  plan.collisions_per_particle_and_step = rate * plan.time_step;
  const Duration& duration = scene.run.duration;
  if (duration.time) plan.steps = *duration.time / plan.time_step;
  if (duration.steps) plan.steps = static_cast<double>(*duration.steps);
  if (duration.collisions) plan.steps = *duration.collisions / plan.collisions_per_particle_and_step;
  const double runs = static_cast<double>(scene.run.replicas) * static_cast<double>(plan.particles);
  plan.particle_moves = plan.steps * runs;
  plan.expected_collisions = plan.steps * plan.collisions_per_particle_and_step * runs / 2;
  // A scene that starts without particles which collide: nobody can tell when they will have collided so often.
  if (!std::isfinite(plan.steps)) plan.particle_moves = plan.expected_collisions = HUGE_VAL;
}

/// Intervals of the cadence that the steps expected hold.
double samples_of(const Cadence& cadence, const Plan& plan) {
  const double every = cadence.every;
  if (cadence.unit == Cadence::Unit::time) return plan.steps * plan.time_step / every;
  if (cadence.unit == Cadence::Unit::collisions)
    return plan.steps * plan.collisions_per_particle_and_step / every;
  return plan.steps / every;
}

/// Each sample with its step and time; at most one a step, and one at the start.
template <int D>
double bytes_of_samples(const Setup<D>& setup, const Plan& plan) {
  double bytes = 0;
  for (std::size_t i = 0; i < setup.observers.size(); ++i) {
    const Observe& observe = setup.scene.observe[i];
    const double left_out = observe.start ? 1 / samples_of(*observe.start, plan) : 0;
    const double samples =
        1 + std::min(samples_of(observe.cadence, plan), plan.steps) * std::max(0.0, 1 - left_out);
    for (const auto& observer : make_observers<D>(setup.observers[i], 0))
      bytes += samples * sizeof(double) * static_cast<double>(observer->quantity().size() + 2);
  }
  return bytes * static_cast<double>(plan.replicas);
}

/// What is on or off whatever the family.
template <int D>
void list_features(const Setup<D>& setup, Plan& plan) {
  const Scene& scene = setup.scene;
  bool walled = false;
  for (const auto& sides : scene.domain.sides)
    walled |= sides[0] == Side::specular || sides[1] == Side::specular;
  plan.feature("gravity", !scene.gravity.empty());
  plan.feature("walls", walled);
  if (capabilities(scene).varying_number) plan.feature("open sides", has_open_side(scene.domain));
  if (capabilities(scene).varying_number) plan.feature("sources", !scene.sources.empty());
  if (capabilities(scene).varying_number) plan.feature("inflows", !scene.inflows.empty());
  if (capabilities(scene).outflows) plan.feature("outflows", !scene.outflows.empty());
  if (capabilities(scene).obstacles) plan.feature("obstacles", !scene.obstacles.empty());
  plan.feature("trajectory", scene.output.trajectory.has_value());
  plan.feature("checkpoints", scene.output.checkpoint.has_value());
  for (const ObserverKind& kind : observer_kinds()) {
    if (kind.needs == ObserverSetting::contacts && !capabilities(scene).contacts) continue;
    bool used = false;
    for (const ObserverSpec& spec : setup.observers) used |= spec.what == kind.name;
    plan.feature(fmt::format("observer {}", kind.name), used);
  }
}

/// An open side with neither an inflow nor an outflow is one to vacuum: what a stream beyond it would send back is not there.
void warn_of_vacuum(const Scene& scene, Plan& plan) {
  if (scene.inflows.empty()) return;
  for (std::size_t axis = 0; axis < scene.domain.sides.size(); ++axis)
    for (const bool high : {false, true}) {
      const auto here = [&](const auto& flow) {
        return flow.axis == static_cast<int>(axis) && flow.high == high;
      };
      if (scene.domain.sides[axis][high] != Side::open || std::ranges::any_of(scene.inflows, here) ||
          std::ranges::any_of(scene.outflows, here))
        continue;
      plan.warnings.push_back(fmt::format(
          "nothing comes in by the open side {}-{}, a vacuum: a gas there that streams as the inflow would "
          "send in {:.2g} times as many particles per area",
          axis_name(static_cast<int>(axis)), high ? "high" : "low", neglected_return(scene, axis, high)));
    }
}

/// Evenly spread particles; and the bound, for crossings keep their mass in the mean.
template <int D>
void weigh_by_region(const Setup<D>& setup, Plan& plan) {
  const double real = static_cast<double>(plan.particles) * setup.scene.method.weight;
  plan.particles = static_cast<std::uint64_t>(real * setup.weights->mean_inverse());
  plan.most_particles = static_cast<std::uint64_t>(real / setup.weights->lightest());
}

/// A run takes a step at least, whose end is that of the run where the step knows it.
void warn_of_long_step(const Scene& scene, Plan& plan) {
  if (!(plan.steps < 1)) return;
  plan.warnings.push_back(
      fmt::format("'run.duration' is {:.2g} time steps long: {}; shorten 'method.time-step'", plan.steps,
                  scene.run.duration.time ? "the only step is cut" : "the only step runs beyond the end"));
  plan.particle_moves /= plan.steps;
  plan.expected_collisions /= plan.steps;
  plan.steps = 1;
}
}  // namespace

template <int D>
Plan plan_of(const Setup<D>& setup) {
  const Scene& scene = setup.scene;
  Plan plan;
  plan.method = scene.method.preset;
  plan.replicas = scene.run.replicas;
  plan.particles = setup.particles + added_count(scene);
  if (setup.weights) weigh_by_region(setup, plan);
  expect_work(setup, plan);
  warn_of_long_step(scene, plan);
  plan.bytes_of_samples = bytes_of_samples(setup, plan);
  setup.method->plan(plan);
  list_features(setup, plan);
  warn_of_vacuum(scene, plan);
  return plan;
}

template Plan plan_of<2>(const Setup<2>&);
template Plan plan_of<3>(const Setup<3>&);

Plan plan(const Scene& scene) {
  return scene.domain.dimension == 2 ? plan_of(set_up<2>(scene, {})) : plan_of(set_up<3>(scene, {}));
}

}  // namespace sandglass
