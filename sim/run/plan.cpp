#include "sim/run/time_step.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {

template <int D>
double bytes_of(const Scene& scene, const Setup<D>& setup) {
  const double per_cell = setup.parameters.factor.formula != nullptr ? 8 + 3 * 4 + 8 : 8;
  return 2 * sizeof(Phase<D>) + sizeof(typename ParticleStore<D>::Place) + (scene.output.ids ? 16 : 0) +
         per_cell * setup.grid.size() / static_cast<double>(setup.particles);
}

struct Feature {
  std::string name;
  bool used;
};

template <int D>
std::vector<Feature> features_of(const Scene& scene, const Setup<D>& setup) {
  bool walls = false;
  for (bool walled : setup.motion.walled) walls |= walled;
  std::vector<Feature> features = {
      {"contact factor of the local density", setup.parameters.factor.formula != nullptr},
      {"offset along the momentum change", setup.parameters.offset.consistent != 0},
      {"random offset", setup.parameters.offset.random != 0},
      {"gravity", !setup.motion.gravity.isZero(0)},
      {"specular walls", walls},
      {"particle identities", scene.output.ids},
      {"momentum carried by offsets (observer pressure)", setup.parameters.measure_transfer},
      {"trajectory", scene.output.trajectory.has_value()},
      {"checkpoints", scene.output.checkpoint.has_value()},
  };
  for (const char* what : {"energy", "temperature", "momentum", "moments", "velocity-histogram", "collisions",
                           "pressure", "crossings", "fields", "shear-mode"}) {
    bool used = false;
    for (const ObserverSpec& spec : setup.observers) used |= spec.what == what;
    features.push_back({fmt::format("observer {}", what), used});
  }
  return features;
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
  plan.cells = setup.grid.size();
  plan.particles_per_cell = static_cast<double>(setup.particles) / static_cast<double>(plan.cells);
  const double thermal = thermal_speed(scene);
  const double mean_speed = thermal * std::sqrt(D == 2 ? M_PI / 2 : 8 / M_PI);
  const double free_path = mean_speed / expected_collision_rate(scene, setup, scene.initial.temperature);
  plan.cell_size_in_mean_free_paths = std::pow(setup.grid.cell_volume(), 1.0 / D) / free_path;
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
