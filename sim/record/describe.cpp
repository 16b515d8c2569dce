#include "sim/record/describe.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandglass {
namespace {

std::string or_unknown(const std::string& word) { return word.empty() ? "unknown" : word; }

std::string origin(const Provenance& made) {
  const std::string planted =
      made.planted_fault.empty() ? "" : fmt::format("; PLANTED FAULT '{}'", made.planted_fault);
  return fmt::format("written by Sandglass {} (commit {}), {}{}\n", or_unknown(made.program_version),
                     or_unknown(made.commit), or_unknown(made.created), planted);
}

std::string shape_of(const Quantity& quantity) {
  return quantity.shape.empty() ? "" : fmt::format(" [{}]", fmt::join(quantity.shape, " x "));
}

/// One line per quantity: how often it was sampled in the first replica.
std::string series_lines(const Record& record) {
  if (record.replicas.empty()) return "";
  std::string text;
  for (const Series& series : record.replicas.front().series)
    text += fmt::format("  {}{}: {} samples [{}]\n", series.quantity.name, shape_of(series.quantity),
                        series.samples(), series.quantity.units);
  return text;
}

std::string trajectory_line(const std::vector<Frame>& frames, int dimension) {
  if (frames.empty()) return "no trajectory\n";
  std::size_t fewest = frames.front().particles(dimension), most = fewest;
  for (const Frame& frame : frames) {
    fewest = std::min(fewest, frame.particles(dimension));
    most = std::max(most, frame.particles(dimension));
  }
  const std::string count = fewest == most ? std::to_string(most) : fmt::format("{} to {}", fewest, most);
  return fmt::format("trajectory: {} frames of {} particles, time {} to {}\n", frames.size(), count,
                     frames.front().time, frames.back().time);
}

}  // namespace

std::string describe_record(const Record& record) {
  std::string text = origin(record.provenance);
  if (!record.broken.empty()) text += fmt::format("BROKEN RUN: {}\n", record.broken);
  for (const std::string& warning : record.warnings) text += fmt::format("warning: {}\n", warning);
  for (const std::string& change : record.changes) text += fmt::format("resumed with {}\n", change);
  text += fmt::format("box {} ({}), {} replicas\n", fmt::join(record.box_size, " x "),
                      fmt::join(record.boundary, ", "), record.replicas.size());
  text += series_lines(record);
  text += fmt::format("{} estimates\n", record.estimates.size());
  text += trajectory_line(record.trajectory, record.dimension);
  if (record.state)
    text += fmt::format("checkpoint: replica {}, step {}, time {}\n", record.replicas.size() + 1,
                        record.state->step, record.state->time);
  return text;
}

}  // namespace sandglass
