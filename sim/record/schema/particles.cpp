#include "sim/record/schema/particles.hpp"

#include "sim/record/schema/columns.hpp"
#include "sim/record/schema/names.hpp"
#include "sim/record/schema/quantity.hpp"

#include <algorithm>

namespace sandglass::schema {
namespace {

std::size_t particles_in(const Frame& frame, std::size_t width) {
  const std::size_t count = frame.position.size() / width;
  const auto whole = [count](const NamedColumn& column) { return column.particles() == count; };
  if (frame.position.size() != count * width || frame.velocity.size() != count * width ||
      !std::ranges::all_of(frame.columns.all(), whole))
    throw hdf5::Failure("a frame holds different numbers of positions, velocities and values of a column");
  return count;
}

std::vector<double> stacked(std::span<const Frame> frames, std::vector<double> Frame::*member,
                            std::size_t row) {
  std::vector<double> all(frames.size() * row, no_value);
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    std::copy((frames[frame].*member).begin(), (frames[frame].*member).end(),
              all.begin() + static_cast<std::ptrdiff_t>(frame * row));
  return all;
}

std::vector<double> cut(const std::vector<double>& all, std::size_t frame, std::size_t row,
                        std::size_t count) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(frame * row);
  return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
}

/// H5MD lets elements that are sampled together share their clock.
void link_clock(const hdf5::Writer& element, const hdf5::Writer& source) {
  element.link(names::time, source, names::time);
  element.link(names::step, source, names::step);
}

}  // namespace

void write_convention(const hdf5::Writer& file, const Provenance& provenance) {
  const hdf5::Writer group = file.group("h5md");
  group.attribute("version", std::vector<int>{h5md_major, h5md_minor});
  group.group("author").attribute("name", "unknown");
  const hdf5::Writer creator = group.group("creator");
  creator.attribute("name", "Sandglass");
  creator.attribute("version", provenance.program_version);
}

void write_box(const hdf5::Writer& group, const Record& record) {
  const auto axes = static_cast<std::size_t>(record.dimension);
  if (record.box_size.size() != axes || record.boundary.size() != axes)
    throw hdf5::Failure("the box does not have the dimension of the record");
  group.attribute("dimension", record.dimension);
  group.attribute("boundary", record.boundary);
  group.numbers<double>("edges", {axes}, record.box_size);
}

void read_box(const hdf5::Reader& group, Record& record) {
  const std::vector<int> dimension = group.attribute<int>("dimension");
  if (dimension.size() != 1 || dimension[0] < 1 || dimension[0] > 3)
    group.fail("dimension", "is not 1, 2 or 3");
  record.dimension = dimension[0];
  const auto axes = static_cast<std::size_t>(record.dimension);
  record.boundary = group.words("boundary");
  if (record.boundary.size() != axes) group.fail("boundary", "does not have one word per axis");
  record.box_size = group.numbers<double>("edges", {axes});
}

void write_clock(const hdf5::Writer& element, std::span<const Frame> frames) {
  std::vector<double> times;
  std::vector<std::uint64_t> steps;
  for (const Frame& frame : frames) {
    times.push_back(frame.time);
    steps.push_back(frame.step);
  }
  element.numbers<double>(names::time, {frames.size()}, times);
  element.numbers<std::uint64_t>(names::step, {frames.size()}, steps);
}

void write_trajectory(const hdf5::Writer& group, std::span<const Frame> frames, int dimension) {
  if (frames.empty()) return;
  const auto width = static_cast<std::size_t>(dimension);
  std::vector<std::uint64_t> counts;
  for (const Frame& frame : frames) counts.push_back(particles_in(frame, width));
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  const hdf5::Extents extents = {frames.size(), most, width};

  group.numbers<std::uint64_t>(names::count, {frames.size()}, counts);
  const hdf5::Writer positions = group.group(names::position);
  positions.numbers<double>(names::value, extents, stacked(frames, &Frame::position, most * width));
  write_clock(positions, frames);
  const hdf5::Writer velocities = group.group(names::velocity);
  velocities.numbers<double>(names::value, extents, stacked(frames, &Frame::velocity, most * width));
  link_clock(velocities, positions);
  for (const ColumnInfo& info : columns_of(frames)) {
    const hdf5::Writer element = group.group(link_of_name(info.name));
    write_column(element, info, frames, most);
    link_clock(element, positions);
  }
}

std::vector<Frame> read_trajectory(const hdf5::Reader& group, int dimension) {
  if (!group.has(names::position)) return {};
  const auto width = static_cast<std::size_t>(dimension);
  const auto counts = group.numbers<std::uint64_t>(names::count).values;
  const std::size_t most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  const hdf5::Extents extents = {counts.size(), most, width};
  const auto positions = group.group(names::position).numbers<double>(names::value, extents);
  const auto times = group.group(names::position).numbers<double>(names::time, {counts.size()});
  const auto steps = group.group(names::position).numbers<std::uint64_t>(names::step, {counts.size()});
  const auto velocities = group.group(names::velocity).numbers<double>(names::value, extents);
  std::vector<Frame> frames;
  for (std::size_t frame = 0; frame < counts.size(); ++frame) {
    const std::size_t size = counts[frame] * width;
    frames.push_back({steps[frame], times[frame], cut(positions, frame, most * width, size),
                      cut(velocities, frame, most * width, size)});
  }
  for (const std::string& link : column_links(group)) read_column(group, link, counts, frames);
  return frames;
}

}  // namespace sandglass::schema
