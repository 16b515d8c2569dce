#include "sim/base/error.hpp"
#include "sim/record/atomic_file.hpp"
#include "sim/record/export/format.hpp"

#include <cmath>
#include <iterator>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// Names of the numbers of a column: "spin-x", "spin-y", "spin-z" of a vector of three.
void append_names(std::vector<std::string>& names, const std::string& name, std::size_t components) {
  for (std::size_t k = 0; k < components; ++k)
    names.push_back(components == 1 ? name
                                    : fmt::format("{}-{}", name, std::string_view("xyz").substr(k, 1)));
}

std::vector<std::string> names_of(const Frame& frame, int dimension) {
  const auto axes = static_cast<std::size_t>(dimension);
  std::vector<std::string> names{"step", "time"};
  append_names(names, "position", axes);
  append_names(names, "velocity", axes);
  for (const NamedColumn& column : frame.columns.all())
    append_names(names, column.info.name, column.info.components);
  if (!frame.columns.has(column::diameter)) names.push_back(column::diameter.name);
  return names;
}

void put(std::string& line, std::span<const double> numbers) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(line), ",{}", field(number));
}

void write_particles(const Record& record, const std::string& path, const ParticleShape& shape) {
  AtomicFile file(path);
  const std::vector<Frame> frames = frames_of(record);
  const auto axes = static_cast<std::size_t>(record.dimension);
  file.write(fmt::format("{}\n", fmt::join(names_of(frames.front(), record.dimension), ",")));
  for (const Frame& frame : frames)
    for (std::size_t i = 0; i < frame.particles(record.dimension); ++i) {
      std::string line = fmt::format("{},{}", frame.step, field(frame.time));
      put(line, std::span(frame.position).subspan(i * axes, axes));
      put(line, std::span(frame.velocity).subspan(i * axes, axes));
      for (const NamedColumn& column : frame.columns.all())
        std::visit(
            [&](const auto& values) {
              for (std::size_t k = 0; k < column.info.components; ++k)
                fmt::format_to(std::back_inserter(line), ",{}", values[i * column.info.components + k]);
            },
            column.numbers);
      if (!frame.columns.has(column::diameter)) put(line, {&shape.diameter, 1});
      file.write(line + "\n");
    }
  file.commit();
}

bool has_series(const Record& record) {
  const auto any = [](const std::vector<Series>& list) { return !list.empty(); };
  return (!record.replicas.empty() && any(record.replicas.front().series)) ||
         (record.state && any(record.state->series));
}

}  // namespace

Paths csv_paths(const Record& record, const std::string& path) {
  const std::string stem = without_ending(path, ".csv");
  Paths paths{path, stem + "-estimates.csv"};
  if (!frames_of(record).empty()) paths.push_back(stem + "-particles.csv");
  if (paths.size() == 2 && !has_series(record))
    throw InputError(
        "the record holds neither series nor particles, of which a table could be made: add [[observe]] to "
        "the "
        "scene and run it again");
  return paths;
}

void export_csv(const Record& record, const Paths& paths, const ParticleShape& shape) {
  AtomicFile series(paths[0]);
  series.write("quantity,component,units,bin_low,bin_high,replica,step,time,value\n");
  for (std::size_t replica = 0; replica < record.replicas.size(); ++replica)
    for (const Series& one : record.replicas[replica].series) write_series(series, one, replica);
  if (record.state)
    for (const Series& one : record.state->series) write_series(series, one, record.replicas.size());
  AtomicFile estimates(paths[1]);
  estimates.write(
      "quantity,component,units,bin_low,bin_high,value,standard_error,effective_samples,start_time,"
      "drifts\n");
  for (const Estimate& estimate : record.estimates) write_estimate(estimates, estimate);
  if (paths.size() > 2) write_particles(record, paths[2], shape);
  series.commit();
  estimates.commit();
}

}  // namespace sandglass
