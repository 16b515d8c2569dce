#include "sim/run/estimates.hpp"

#include "sim/base/statistics.hpp"

#include <algorithm>
#include <limits>

namespace sandglass {

namespace {

std::vector<double> component_of(const Series& series, std::size_t component) {
  const std::size_t size = series.quantity.size();
  std::vector<double> values;
  for (std::size_t sample = 0; sample < series.samples(); ++sample)
    values.push_back(series.value[sample * size + component]);
  return values;
}

/// Increments per time between samples.
std::vector<double> rates_of(const Series& series, std::size_t component) {
  std::vector<double> values = component_of(series, component), rates;
  for (std::size_t i = 1; i < values.size(); ++i)
    rates.push_back((values[i] - values[i - 1]) / (series.time[i] - series.time[i - 1]));
  return rates;
}

Mean mean_of(const std::vector<std::vector<double>>& samples) {
  if (samples.size() == 1) return mean_of_correlated(samples.front());
  std::vector<double> means;
  for (const std::vector<double>& replica : samples) means.push_back(mean_of_correlated(replica).value);
  return mean_of_independent(means);
}

Estimate estimate_series(const std::vector<Replica>& replicas, std::size_t index, bool cumulative) {
  Estimate estimate;
  estimate.quantity = replicas.front().series[index].quantity;
  if (cumulative) {
    estimate.quantity.name += "-rate";
    estimate.quantity.units += " time^-1";
    estimate.quantity.summary = "rate of: " + estimate.quantity.summary;
  }
  estimate.effective_samples = std::numeric_limits<double>::infinity();
  for (std::size_t component = 0; component < estimate.quantity.size(); ++component) {
    std::vector<std::vector<double>> samples;
    for (const Replica& replica : replicas)
      samples.push_back(cumulative ? rates_of(replica.series[index], component)
                                   : component_of(replica.series[index], component));
    const Mean mean = mean_of(samples);
    estimate.value.push_back(mean.value);
    estimate.standard_error.push_back(mean.standard_error);
    estimate.effective_samples = std::min(estimate.effective_samples, mean.effective_samples);
  }
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
