#include "sim/run/estimates.hpp"

#include "sim/base/statistics.hpp"
#include "sim/base/steady.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass {

namespace {
/// Rows of a series, one a component.
Rows components_of(const Series& series) {
  const std::size_t size = series.quantity.size();
  Rows rows(size);
  for (std::size_t i = 0; i < series.value.size(); ++i) rows[i % size].push_back(series.value[i]);
  return rows;
}

/// Increments per time between samples.
Rows rates_of(const Series& series) {
  Rows rows = components_of(series);
  for (std::vector<double>& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      row[i] = (row[i + 1] - row[i]) / (series.time[i + 1] - series.time[i]);
    row.pop_back();
  }
  return rows;
}

/// Mean over replicas, sample by sample, as long as the shortest: noise averages out, a transient stays.
Rows ensemble_mean(const std::vector<Rows>& replicas) {
  Rows mean = replicas.front();
  for (std::size_t component = 0; component < mean.size(); ++component) {
    std::vector<double>& row = mean[component];
    for (std::size_t i = 1; i < replicas.size(); ++i) {
      const std::vector<double>& other = replicas[i][component];
      row.resize(std::min(row.size(), other.size()));
      for (std::size_t sample = 0; sample < row.size(); ++sample) row[sample] += other[sample];
    }
    for (double& value : row) value /= static_cast<double>(replicas.size());
  }
  return mean;
}

/// Of one component, from a sample on.
Mean mean_of(const std::vector<Rows>& replicas, std::size_t component, std::size_t from) {
  std::vector<Mean> means;
  for (const Rows& rows : replicas)
    means.push_back(mean_of_correlated(std::span(rows[component]).subspan(from)));
  if (means.size() == 1) return means.front();
  std::vector<double> values;
  for (const Mean& mean : means) values.push_back(mean.value);
  return mean_of_independent(values);
}

Quantity rate_of(Quantity quantity) {
  quantity.name += "-rate";
  quantity.units += " time^-1";
  quantity.summary = "rate of: " + quantity.summary;
  return quantity;
}

Estimate estimate_series(const std::vector<Replica>& replicas, std::size_t index, bool cumulative) {
  const Series& first = replicas.front().series[index];
  std::vector<Rows> rows;
  for (const Replica& replica : replicas)
    rows.push_back(cumulative ? rates_of(replica.series[index]) : components_of(replica.series[index]));
  const Rows together = ensemble_mean(rows);
  const std::size_t from = steady_from(together);
  Estimate estimate;
  estimate.quantity = cumulative ? rate_of(first.quantity) : first.quantity;
  estimate.start_time = first.time[from];
  double fewest = std::numeric_limits<double>::infinity();
  for (std::size_t component = 0; component < together.size(); ++component) {
    const Mean mean = mean_of(rows, component, from);
    estimate.value.push_back(mean.value);
    estimate.standard_error.push_back(mean.standard_error);
    estimate.effective_samples = mean.effective_samples;
    if (mean.standard_error > rounding_share * std::abs(mean.value))
      fewest = std::min(fewest, mean.effective_samples);
    estimate.drifts = estimate.drifts || drifts(std::span(together[component]).subspan(from));
  }
  if (std::isfinite(fewest)) estimate.effective_samples = fewest;
  return estimate;
}

}  // namespace

std::vector<Estimate> estimate(const std::vector<Replica>& replicas,
                               const std::set<std::string>& cumulative) {
  std::vector<Estimate> estimates;
  if (replicas.empty()) return estimates;
  for (std::size_t index = 0; index < replicas.front().series.size(); ++index) {
    const bool counts = cumulative.contains(replicas.front().series[index].quantity.name);
    const auto enough = [&](const Replica& replica) {
      return replica.series[index].samples() > (counts ? 1u : 0u);
    };
    if (std::ranges::all_of(replicas, enough)) estimates.push_back(estimate_series(replicas, index, counts));
  }
  return estimates;
}

}  // namespace sandglass
