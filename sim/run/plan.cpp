#include "sim/method/event_driven/cells.hpp"
#include "sim/run/time_step.hpp"
#include "sim/scene/catalogue.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

/// The particle, what comes next, about two entries of the calendar with their slack, the view, and a head per cell.
template <int D>
double hard_bytes_of(const Setup<D>& setup) {
  const event_driven::Parameters<D>& hard = setup.hard;
  const double cells =
      hard.geometry.box.prod() / std::pow(hard.cell_edge(), D) / static_cast<double>(setup.particles);
  return sizeof(event_driven::Particle<D>) + sizeof(event_driven::Next) + 36 + sizeof(Phase<D>) + 4 * cells +
         (hard.rough ? sizeof(Spin<D>) : 0) + (hard.species.size() > 1 ? 1 : 0) +
         (hard.contact_time > 0 ? 8 : 0) + (hard.keep_ids ? 8 : 0);
}

template <int D>
double bytes_of(const Scene& scene, const Setup<D>& setup) {
  if (is_event_driven(scene)) return hard_bytes_of(setup);
  const double per_cell = setup.parameters.factor.formula != nullptr ? 8 + 3 * 4 + 8 : 8;
  return 2 * sizeof(Phase<D>) + sizeof(typename ParticleStore<D>::Place) + (scene.output.ids ? 16 : 0) +
         per_cell * setup.grid.size() / static_cast<double>(setup.particles);
}

struct Feature {
  std::string name;
  bool used;
};

template <int D>
std::vector<Feature> stochastic_features(const Setup<D>& setup) {
  return {{"contact factor of the local density", setup.parameters.factor.formula != nullptr},
          {"offset along the momentum change", setup.parameters.offset.consistent != 0},
          {"random offset", setup.parameters.offset.random != 0},
          {"momentum carried by offsets (observer pressure)", setup.parameters.measure_transfer}};
}

template <int D>
std::vector<Feature> hard_features(const Scene& scene, const Setup<D>& setup) {
  return {{"several species", setup.hard.species.size() > 1},
          {"spins and rough contacts", setup.hard.rough},
          {"collapse guard: contact time", scene.method.guard == CollapseGuard::contact_time},
          {"collapse guard: velocity-dependent restitution",
           scene.method.guard == CollapseGuard::velocity_dependent},
          {"obstacles", !scene.obstacles.empty()},
          {"collisional virial (observer pressure)", setup.hard.measure_transfer},
          {"impact parameters", setup.hard.impact_bins > 0},
          {"event trace", scene.output.event_trace.has_value()}};
}

template <int D>
std::vector<Feature> features_of(const Scene& scene, const Setup<D>& setup) {
  bool walls = false;
  for (bool walled : setup.motion.walled) walls |= walled;
  std::vector<Feature> features =
      is_event_driven(scene) ? hard_features(scene, setup) : stochastic_features(setup);
  const std::vector<Feature> common = {{"gravity", !setup.motion.gravity.isZero(0)},
                                       {"walls", walls},
                                       {"particle identities", scene.output.ids || setup.hard.keep_ids},
                                       {"trajectory", scene.output.trajectory.has_value()},
                                       {"checkpoints", scene.output.checkpoint.has_value()}};
  features.insert(features.end(), common.begin(), common.end());
  for (const std::string& what : observer_names()) {
    if (find_observer(what)->event_driven_only && !is_event_driven(scene)) continue;
    bool used = false;
    for (const ObserverSpec& spec : setup.observers) used |= spec.what == what;
    features.push_back({fmt::format("observer {}", what), used});
  }
  return features;
}

template <int D>
double free_path(const Scene& scene, const Setup<D>& setup) {
  return mean_speed(D, thermal_speed(scene)) /
         expected_collision_rate(scene, setup, scene.initial.temperature);
}

/// Steps and collisions that the duration stands for, at the initial temperature.
template <int D>
void expect_work(const Scene& scene, const Setup<D>& setup, Plan& plan) {
  const double rate = expected_collision_rate(scene, setup, scene.initial.temperature);
  plan.time_step =
      scene.method.time_step.fixed.value_or(scene.method.time_step.collisions.value_or(0) / rate);
  plan.collisions_per_particle_and_step = rate * plan.time_step;
  const Duration& duration = scene.run.duration;
  if (duration.time) plan.steps = *duration.time / plan.time_step;
  if (duration.steps) plan.steps = static_cast<double>(*duration.steps);
  if (duration.collisions) plan.steps = *duration.collisions / plan.collisions_per_particle_and_step;
  const double runs = static_cast<double>(scene.run.replicas) * static_cast<double>(setup.particles);
  plan.particle_moves = plan.steps * runs;
  plan.expected_collisions = plan.steps * plan.collisions_per_particle_and_step * runs / 2;
  if (is_event_driven(scene)) plan.particle_moves = 2 * plan.expected_collisions;  // only partners move
}

void warn(Plan& plan) {
  if (plan.cell_size_in_mean_free_paths > 1)
    plan.warnings.push_back(
        fmt::format("cells are {:.2g} mean free paths wide: transport is smeared over more than a free path; "
                    "lower 'method.cell-size'",
                    plan.cell_size_in_mean_free_paths));
  if (plan.collisions_per_particle_and_step > 0.5)
    plan.warnings.push_back(
        fmt::format("{:.2g} collisions per particle and step: moving and colliding no longer decouple; "
                    "shorten 'method.time-step'",
                    plan.collisions_per_particle_and_step));
  if (plan.particles_per_cell < 5)
    plan.warnings.push_back(
        fmt::format("{:.2g} particles per cell: the same pairs meet again and again; widen the cells or "
                    "lower 'method.weight'",
                    plan.particles_per_cell));
}

template <int D>
Plan plan_hard(const Scene& scene, const Setup<D>& setup, Plan plan) {
  plan.cells = event_driven::Cells<D>(setup.hard.geometry, setup.hard.cell_edge()).size();
  plan.particles_per_cell = static_cast<double>(setup.particles) / static_cast<double>(plan.cells);
  plan.cell_size_in_mean_free_paths = setup.hard.cell_edge() / free_path(scene, setup);
  plan.columns = {"position", "velocity", "local time", "next event", "cell"};
  if (setup.hard.rough) plan.columns.push_back("spin");
  if (setup.hard.species.size() > 1) plan.columns.push_back("species");
  if (setup.hard.contact_time > 0) plan.columns.push_back("last contact");
  if (setup.hard.keep_ids) plan.columns.push_back("id");
  plan.bytes_per_particle = bytes_of(scene, setup);
  expect_work(scene, setup, plan);
  return plan;
}

template <int D>
Plan plan_of(const Scene& scene) {
  const Setup<D> setup = set_up<D>(scene, {});
  Plan plan;
  plan.method = scene.method.preset;
  plan.replicas = scene.run.replicas;
  plan.particles = setup.particles;
  for (const Feature& feature : features_of(scene, setup))
    (feature.used ? plan.used : plan.left_out).push_back(feature.name);
  if (is_reservoir(scene)) {
    plan.time_step = scene.method.time_step.fixed.value();
    plan.steps = scene.run.duration.time ? *scene.run.duration.time / plan.time_step
                                         : static_cast<double>(scene.run.duration.steps.value_or(0));
    return plan;
  }
  if (is_event_driven(scene)) return plan_hard(scene, setup, std::move(plan));
  plan.cells = setup.grid.size();
  plan.particles_per_cell = static_cast<double>(setup.particles) / static_cast<double>(plan.cells);
  plan.cell_size_in_mean_free_paths = std::pow(setup.grid.cell_volume(), 1.0 / D) / free_path(scene, setup);
  plan.columns = {"position", "velocity", "cell"};
  if (scene.output.ids) plan.columns.push_back("id");
  plan.bytes_per_particle = bytes_of(scene, setup);
  expect_work(scene, setup, plan);
  warn(plan);
  return plan;
}

}  // namespace

Plan plan(const Scene& scene) { return scene.domain.dimension == 2 ? plan_of<2>(scene) : plan_of<3>(scene); }

}  // namespace sandglass
