#include "sim/record/atomic_file.hpp"
#include "sim/record/export/format.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace sandglass {
namespace {

/// RFC 4180: quoted when it holds a comma, a quote or a line break.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

/// Empty where a number is not known.
std::string field(double number) { return std::isnan(number) ? "" : fmt::format("{}", number); }

/// "quantity,component,units,bin_low,bin_high" of one component.
std::string heading_of(const Quantity& quantity, std::size_t component) {
  const std::string name =
      component < quantity.components.size() ? quantity.components[component] : std::to_string(component);
  std::string text = fmt::format("{},{},{}", field(quantity.name), field(name), field(quantity.units));
  const std::size_t bins = quantity.shape.empty() ? 0 : quantity.shape.back();
  if (bins == 0 || quantity.axis.size() != bins + 1) return text + ",,";
  return text + fmt::format(",{},{}", quantity.axis[component % bins], quantity.axis[component % bins + 1]);
}

void write_series(AtomicFile& file, const Series& series, std::size_t replica) {
  std::string text;
  const std::size_t width = series.quantity.size();
  for (std::size_t component = 0; component < width; ++component) {
    const std::string heading = heading_of(series.quantity, component);
    for (std::size_t sample = 0; sample < series.samples(); ++sample)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", heading, replica, series.step[sample],
                     field(series.time[sample]), field(series.value[sample * width + component]));
  }
  file.write(text);
}

void write_estimate(AtomicFile& file, const Estimate& estimate) {
  for (std::size_t component = 0; component < estimate.value.size(); ++component)
    file.write(fmt::format("{},{},{},{},{},{}\n", heading_of(estimate.quantity, component),
                           field(estimate.value[component]), field(estimate.standard_error[component]),
                           field(estimate.effective_samples), field(estimate.start_time),
                           estimate.drifts ? "yes" : "no"));
}

}  // namespace

Paths csv_paths(const Record&, const std::string& path) {
  return {path, without_ending(path, ".csv") + "-estimates.csv"};
}

void export_csv(const Record& record, const Paths& paths, const ParticleShape&) {
  AtomicFile series(paths[0]);
  series.write("quantity,component,units,bin_low,bin_high,replica,step,time,value\n");
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica)
    for (const Series& one : record.replicas[replica].series) write_series(series, one, replica);
  AtomicFile estimates(paths[1]);
  estimates.write(
      "quantity,component,units,bin_low,bin_high,value,standard_error,effective_samples,start_time,"
      "drifts\n");
  for (const Estimate& estimate : record.estimates) write_estimate(estimates, estimate);
  series.commit();
  estimates.commit();
}

}  // namespace sandglass
