#include "validation/check/subject.hpp"

#include "sim/base/error.hpp"
#include "sim/base/packing.hpp"
#include "sim/base/spelling.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/finite_size.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/pair_deficit.hpp"
#include "validation/law/state.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t enough_replicas = 8;

double mean(const std::vector<double>& samples) { return mean_of_independent(samples).value; }

/// Linear between samples; the ends hold outside.
double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto upper = std::lower_bound(x.begin(), x.end(), at);
  if (upper == x.begin()) return y.front();
  if (upper == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(upper - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}
}  // namespace

Subject::Subject(const Record& record)
    : record_(&record), scene_(read_scene_text(record.scene, "scene of the record")) {
  if (record.replicas.empty())
    throw InputError(
        "the record holds no finished replica: resume the run that wrote it, or run its scene again");
  particles_ = static_cast<double>(particle_count(scene_, species()));
}

double Subject::particles_per_cell() const {
  double cells = 1;
  for (const double count : cells_along(scene_)) cells *= count;
  return cells_along(scene_).empty() ? 0 : particles_ / cells;
}

double Subject::collisions_per_step() const {
  if (scene_.method.time_step.collisions) return *scene_.method.time_step.collisions;
  if (scene_.method.time_step.cell_fraction) {
    const auto& counters = record_->replicas.front().counters;
    return 2 * counters.at("collisions") / particles_ / counters.at("steps");
  }
  return scene_.method.time_step.fixed.value_or(0) * law::collision_rate(gas(scene_.initial.temperature));
}

law::Bounded Subject::missing_pairs() const {
  const double per_cell = particles_per_cell(), cells = particles_ / per_cell;
  if (!loses_pairs(scene_) || per_cell == 0) return {};
  if (has_full_cells(scene_) && fraction(scene_, species()) >= freezing_fraction(dimension())) {
    const double most = (1 - law::long_wave_structure(gas(1))) / per_cell;
    return {most / 2, 0, most / 2};
  }
  const double edge = std::pow(volume(scene_.domain) / cells, 1.0 / dimension());
  const law::Bounded part = law::pair_deficit(gas(1), {per_cell, edge, density_window(scene_), cells});
  if (least_cell_edge(scene_) == 0) return part;
  const double most = part.value + part.bound;  // partners at contact push each other apart less
  return {most / 2, 0, most / 2};
}

double Subject::pair_factor() const {
  if (!capabilities(scene_).contacts) return (particles_ - 1) / particles_;
  return fixed_count_factor(dimension(), fraction(scene_, species()), particles_);
}

law::Gas Subject::gas(double temperature) const {
  return {dimension(), species().diameter,          species().mass,
          temperature, fraction(scene_, species()), species().restitution};
}

bool Subject::has(const std::string& quantity) const {
  const std::vector<Series>& all = record_->replicas.front().series;
  return std::any_of(all.begin(), all.end(), [&](const Series& s) { return s.quantity.name == quantity; });
}

const Series& Subject::series(std::size_t replica, const std::string& quantity) const {
  for (const Series& series : record_->replicas.at(replica).series)
    if (series.quantity.name == quantity) return series;
  throw InputError(
      fmt::format("the record has no series '{}': add the observer to the scene and run it again", quantity));
}

std::vector<double> Subject::column(std::size_t replica, const std::string& quantity,
                                    const std::string& component) const {
  const Series& found = series(replica, quantity);
  const std::vector<std::string>& names = found.quantity.components;
  const auto name = std::find(names.begin(), names.end(), component);
  if (name == names.end() && !(component.empty() && found.quantity.size() == 1))
    throw InputError(unknown_word("component of '" + quantity + "'", component, names));
  const std::size_t width = found.quantity.size();
  const std::size_t offset = component.empty() ? 0 : static_cast<std::size_t>(name - names.begin());
  std::vector<double> column(found.samples());
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = found.value.at(i * width + offset);
  return column;
}

std::vector<double> Subject::collisions_per_particle(std::size_t replica,
                                                     const Series& series_of_times) const {
  const std::vector<double> times = series(replica, "collisions").time;
  const std::vector<double> collisions = column(replica, "collisions", "");
  std::vector<double> result;
  for (double time : series_of_times.time)
    result.push_back(2 / particles_ * interpolated(times, collisions, time));
  return result;
}

double Subject::mean_temperature() const {
  double sum = 0;
  for (std::size_t replica = 0; replica < replicas(); ++replica)
    sum += mean(column(replica, "temperature", "total"));
  return sum / static_cast<double>(replicas());
}

bool has_contact_value(const Scene& scene) {
  return capabilities(scene).contacts || has_contact_factor(scene);
}

Mean pooled(const std::vector<std::vector<double>>& samples_of_replicas) {
  std::vector<double> values;
  std::vector<Mean> means;
  for (const std::vector<double>& samples : samples_of_replicas) {
    means.push_back(mean_of_correlated(samples));
    values.push_back(means.back().value);
  }
  return values.size() >= enough_replicas ? mean_of_independent(values) : average(means);
}

}  // namespace sandglass
