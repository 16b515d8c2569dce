#include "validation/check/pipe.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/free_flight.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

int pipe_axis(const Scene& scene) {
  if (!capabilities(scene).particles || scene.species.size() != 1 || !scene.obstacles.empty() ||
      !scene.sources.empty() || !scene.given.empty() || is_rough(scene) || has_open_side(scene.domain))
    return -1;
  int found = -1;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis) {
    if (!is_periodic_along(scene, axis)) continue;
    if (found >= 0) return -1;
    found = static_cast<int>(axis);
  }
  return found;
}

bool is_falling_pipe(const Scene& scene) {
  const int along = pipe_axis(scene);
  if (along < 0 || scene.gravity.empty()) return false;
  for (std::size_t axis = 0; axis < scene.gravity.size(); ++axis)
    if ((scene.gravity[axis] != 0) != (static_cast<int>(axis) == along)) return false;
  return true;
}

double sign_of_gravity(const Scene& scene) {
  return scene.gravity[static_cast<std::size_t>(pipe_axis(scene))] > 0 ? 1 : -1;
}

bool is_pipe_at_rest(const Scene& scene) {
  return pipe_axis(scene) >= 0 && is_weightless(scene) && scene.species.front().restitution == 1 &&
         std::all_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
           return wall.surface.rule != SurfaceKind::thermal && wall.surface.restitution == 1 &&
                  wall.velocity.empty() && wall.amplitude == 0;
         });
}

std::vector<double> PipeSlices::slice(std::size_t which) const {
  std::vector<double> series(samples());
  for (std::size_t t = 0; t < series.size(); ++t) series[t] = count[t * slices + which];
  return series;
}

namespace {
std::size_t first_sample(const Series& series, double from) {
  const auto first = static_cast<std::size_t>(std::lower_bound(series.time.begin(), series.time.end(), from) -
                                              series.time.begin());
  if (series.samples() < first + 4)
    throw InputError(
        fmt::format("fewer than 4 samples of '{}' from time {} on: run longer, sample more often "
                    "or lower 'settle-time'",
                    series.quantity.name, from));
  return first;
}

double equal_interval(const Series& series, std::size_t first) {
  const double interval = series.time[first + 1] - series.time[first];
  for (std::size_t t = first + 1; t < series.samples(); ++t)
    if (std::abs(series.time[t] - series.time[t - 1] - interval) > 1e-6 * interval)
      throw InputError(
          "'fields' is not sampled at equal intervals of time: give 'method.time-step' as a time");
  return interval;
}

double late_mean(const Subject& subject, std::size_t replica, const std::string& quantity,
                 const std::string& component, double from) {
  return mean_of_independent(late_samples(subject, replica, quantity, component, from)).value;
}

double real_mass(const Subject& subject) {
  return subject.particles() * subject.scene().method.weight * subject.species().mass;
}
}  // namespace

PipeSlices pipe_slices(const Subject& subject, std::size_t replica, double from, std::size_t slices) {
  const Series& series = subject.series(replica, "fields");
  const auto along = static_cast<std::size_t>(pipe_axis(subject.scene()));
  const std::size_t width = subject.scene().domain.size.size() + 2, bins = series.quantity.shape.at(along);
  if (slices == 0) slices = bins;
  if (series.quantity.size() != bins * width || bins % slices != 0)
    throw InputError(
        fmt::format("'fields' has {} bins along the pipe: give 1 across it, and a multiple of {} "
                    "along it",
                    bins, slices));
  const std::size_t first = first_sample(series, from), merged = bins / slices;
  PipeSlices run{{},
                 slices,
                 subject.scene().domain.size[along] / static_cast<double>(slices),
                 equal_interval(series, first)};
  run.count.assign((series.samples() - first) * slices, 0.0);
  const double particles =
      volume(subject.scene().domain) / static_cast<double>(bins) / subject.scene().method.weight;
  for (std::size_t t = first; t < series.samples(); ++t)
    for (std::size_t bin = 0; bin < bins; ++bin)
      run.count[(t - first) * slices + bin / merged] += series.value[(t * bins + bin) * width] * particles;
  return run;
}

double slice_variance(const std::vector<PipeSlices>& runs, std::span<const std::size_t> replicas) {
  double square = 0, samples = 0;
  for (const std::size_t replica : replicas) {
    const PipeSlices& run = runs[replica];
    double mean = 0;  // of all slices: the number of particles does not change
    for (std::size_t slice = 0; slice < run.slices; ++slice)
      mean += run.count[slice] / static_cast<double>(run.slices);
    for (const double count : run.count) square += (count - mean) * (count - mean);
    samples += static_cast<double>(run.count.size());
  }
  return square / samples;
}

double stream_velocity(const Subject& subject, std::size_t replica, double from) {
  const auto along = static_cast<std::size_t>(pipe_axis(subject.scene()));
  const std::string& axis = subject.series(replica, "momentum").quantity.components.at(along);
  return late_mean(subject, replica, "momentum", axis, from) / real_mass(subject);
}

double typical_speed(const Subject& subject, std::size_t replica, double from) {
  return std::sqrt(2 * late_mean(subject, replica, "energy", "", from) / real_mass(subject));
}

}  // namespace sandglass
