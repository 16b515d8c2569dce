#include "sim/record/schema/particles.hpp"

#include "sim/record/schema/names.hpp"

#include <algorithm>

namespace sandglass::schema {
namespace {

std::size_t particles_in(const Frame& frame, std::size_t width) {
  const std::size_t count = frame.position.size() / width;
  const bool whole = frame.position.size() == count * width && frame.velocity.size() == count * width &&
                     (frame.id.empty() || frame.id.size() == count);
  if (!whole) throw hdf5::Failure("a frame holds different numbers of positions, velocities and ids");
  return count;
}

template <class T>
std::vector<T> stacked(std::span<const Frame> frames, std::vector<T> Frame::*member, std::size_t row,
                       T fill) {
  std::vector<T> all(frames.size() * row, fill);
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    std::copy((frames[frame].*member).begin(), (frames[frame].*member).end(),
              all.begin() + static_cast<std::ptrdiff_t>(frame * row));
  return all;
}

template <class T>
std::vector<T> cut(const std::vector<T>& all, std::size_t frame, std::size_t row, std::size_t count) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(frame * row);
  return std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(count));
}

/// Components of an angular velocity: one for disks, three for spheres; 0 when no frame holds spins.
std::size_t spin_width(std::span<const Frame> frames, std::size_t width) {
  std::size_t components = 0;
  for (const Frame& frame : frames)
    if (const std::size_t count = particles_in(frame, width); count > 0 && components == 0)
      components = frame.spin.size() / count;
  for (const Frame& frame : frames)
    if (frame.spin.size() != components * particles_in(frame, width))
      throw hdf5::Failure("a frame holds different numbers of positions and spins");
  return components;
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
  for (const Frame& frame : frames) {
    counts.push_back(particles_in(frame, width));
    if (frame.id.empty() != frames.front().id.empty()) throw hdf5::Failure("only some frames hold ids");
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  const hdf5::Extents extents = {frames.size(), most, width};

  group.numbers<std::uint64_t>(names::count, {frames.size()}, counts);
  const hdf5::Writer positions = group.group(names::position);
  positions.numbers<double>(names::value, extents, stacked(frames, &Frame::position, most * width, no_value));
  write_clock(positions, frames);
  const hdf5::Writer velocities = group.group(names::velocity);
  velocities.numbers<double>(names::value, extents,
                             stacked(frames, &Frame::velocity, most * width, no_value));
  link_clock(velocities, positions);
  if (const std::size_t components = spin_width(frames, width); components > 0) {
    const hdf5::Writer spins = group.group(names::spin);
    spins.numbers<double>(names::value, {frames.size(), most, components},
                          stacked(frames, &Frame::spin, most * components, no_value));
    link_clock(spins, positions);
  }
  if (frames.front().id.empty()) return;
  const hdf5::Writer ids = group.group(names::id);
  ids.numbers<std::uint64_t>(names::value, {frames.size(), most}, stacked(frames, &Frame::id, most, no_id));
  link_clock(ids, positions);
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
  std::vector<std::uint64_t> ids;
  if (group.has(names::id))
    ids = group.group(names::id).numbers<std::uint64_t>(names::value, {counts.size(), most});
  std::vector<double> spins;
  std::size_t components = 0;
  if (group.has(names::spin)) {
    auto stored = group.group(names::spin).numbers<double>(names::value);
    if (stored.extents.size() != 3 || stored.extents[0] != counts.size() || stored.extents[1] != most)
      group.fail(names::spin, "does not hold one spin per particle and frame");
    components = stored.extents[2];
    spins = std::move(stored.values);
  }

  std::vector<Frame> frames;
  for (std::size_t frame = 0; frame < counts.size(); ++frame) {
    const std::size_t size = counts[frame] * width;
    frames.push_back({steps[frame],
                      times[frame],
                      cut(positions, frame, most * width, size),
                      cut(velocities, frame, most * width, size),
                      {}});
    if (!ids.empty()) frames.back().id = cut(ids, frame, most, counts[frame]);
    if (components > 0) frames.back().spin = cut(spins, frame, most * components, counts[frame] * components);
  }
  return frames;
}

}  // namespace sandglass::schema
