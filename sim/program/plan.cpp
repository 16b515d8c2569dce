#include "sim/program/edited_scene.hpp"
#include "sim/program/memory.hpp"
#include "sim/program/options.hpp"
#include "sim/program/table.hpp"
#include "sim/run/run.hpp"
#include "sim/scene/method/capabilities.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandglass::program {

namespace {

/// What `mpirun -n N` makes of the scene.
std::string of_ranks(const Scene& scene) {
  const std::string whole = kept_whole(scene);
  if (whole.empty())
    return "share the cells, or replicas where there are as many and no checkpoint is asked for";
  return whole + " keeps the cells of a replica on one; several replicas may be shared, without checkpoints";
}

nlohmann::json as_json(const Plan& plan, const Scene& scene) {
  return {{"method", plan.method},
          {"ranks", of_ranks(scene)},
          {"particles", plan.particles},
          {"most_particles", plan.most_particles},
          {"cells", plan.cells},
          {"replicas", plan.replicas},
          {"particles_per_cell", plan.particles_per_cell},
          {"cell_size_in_mean_free_paths", plan.cell_size_in_mean_free_paths},
          {"density_window", plan.density_window},
          {"time_step", plan.time_step},
          {"collisions_per_particle_and_step", plan.collisions_per_particle_and_step},
          {"bytes_per_particle", plan.bytes_per_particle},
          {"bytes_of_samples", plan.bytes_of_samples},
          {"steps", plan.steps},
          {"particle_moves", plan.particle_moves},
          {"expected_collisions", plan.expected_collisions},
          {"columns", plan.columns},
          {"used", plan.used},
          {"left_out", plan.left_out},
          {"warnings", plan.warnings}};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "nothing" : text;
}

/// Whether something but collisions changes the temperature that the work is reckoned at.
bool is_driven(const Scene& scene) {
  const auto drives = [](const Wall& wall) {
    return wall.amplitude > 0 || wall.surface.rule == SurfaceKind::thermal ||
           std::ranges::any_of(wall.velocity, [](double v) { return v != 0; });
  };
  const bool falls = std::ranges::any_of(scene.gravity, [](double component) { return component != 0; });
  return falls || !scene.sources.empty() || !scene.inflows.empty() ||
         std::ranges::any_of(scene.walls, drives);
}

std::string work(const Plan& plan, const Scene& scene) {
  if (!std::isfinite(plan.steps))
    return "unknown: the duration counts collisions, and none can be expected of the particles at the start";
  return fmt::format(
      "{:.4g} steps, {:.3g} particle-moves, {:.3g} collisions{}", plan.steps, plan.particle_moves,
      plan.expected_collisions,
      is_driven(scene) ? ", at the temperature of the start, which what drives the scene will change" : "");
}

std::string most(const Plan& plan) {
  if (plan.most_particles == 0) return "";
  return fmt::format(", evenly spread; at most {} at their mass, if all went where weights are lowest",
                     plan.most_particles);
}

std::string as_text(const Plan& plan, const Scene& scene) {
  std::vector<std::vector<std::string>> rows = {
      {"method", plan.method},
      {"particles", fmt::format("{} x {} replica(s){}", plan.particles, plan.replicas, most(plan))},
      {"cells", fmt::format("{} ({:.3g} particles each, {:.3g} mean free paths wide)", plan.cells,
                            plan.particles_per_cell, plan.cell_size_in_mean_free_paths)},
      {"time step", fmt::format("{:.6g} ({:.3g} collisions per particle)", plan.time_step,
                                plan.collisions_per_particle_and_step)},
      {"memory", memory_words(plan)},
      {"ranks", of_ranks(scene)},
      {"work", work(plan, scene)},
      {"columns", joined(plan.columns)},
      {"in use", joined(plan.used)},
      {"left out", joined(plan.left_out)},
  };
  if (plan.density_window > 0)
    rows.push_back({"contact factor", fmt::format("of the density in {} cells across", plan.density_window)});
  for (const std::string& warning : plan.warnings) rows.push_back({"warning", warning});
  return columns(rows);
}

}  // namespace

int show_plan(const Options& options) {
  const Scene scene = read_edited_scene(options.subject, options.settings);
  Plan planned = plan(scene);
  if (exceeds_memory(planned))
    planned.warnings.push_back(
        "this does not fit into the memory of this machine: run will refuse it; take fewer "
        "particles, or sample less often");
  fmt::print("{}", options.json ? as_json(planned, scene).dump(2) + "\n" : as_text(planned, scene));
  return all_well;
}

}  // namespace sandglass::program
