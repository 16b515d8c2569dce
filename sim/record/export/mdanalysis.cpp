#include "sim/base/error.hpp"
#include "sim/record/export/format.hpp"
#include "sim/record/hdf5/whole_file.hpp"
#include "sim/record/schema/columns.hpp"
#include "sim/record/schema/particles.hpp"

#include <algorithm>

// What MDAnalysis 2.4 reads is narrower than H5MD: three dimensions, a group named "trajectory", a box per
// frame as a 3 x 3 matrix, the same number of particles in every frame, and no observables at other times
// than the positions.

namespace sandglass {
namespace {

std::vector<Frame> frames_in_space(const Record& record) {
  std::vector<Frame> frames = frames_of(record);
  const auto particles = [](const Frame& frame) { return frame.position.size(); };
  const auto other = [&](const Frame& frame) { return particles(frame) != particles(frames.front()); };
  if (std::any_of(frames.begin(), frames.end(), other))
    throw InputError(
        "the number of particles varies from frame to frame, which MDAnalysis cannot read: export to vtp or "
        "xyz");
  for (Frame& frame : frames) {
    frame.position = in_space(frame.position, record.dimension);
    frame.velocity = in_space(frame.velocity, record.dimension);
  }
  return frames;
}

/// It finds ids beside the positions, and what else a particle has as an observable, by its name.
bool is_id(const ColumnInfo& info) { return info.name == column::id.name; }

void keep_ids(std::vector<Frame>& frames) {
  for (Frame& frame : frames) {
    Columns known;
    for (const NamedColumn& column : frame.columns.all())
      if (is_id(column.info)) known.set(column);
    frame.columns = known;
  }
}

void write_observables(const hdf5::Writer& group, const std::vector<Frame>& frames) {
  for (const ColumnInfo& info : schema::columns_of(frames)) {
    if (is_id(info)) continue;
    const hdf5::Writer element = group.group(info.name);
    schema::write_column(element, info, frames, frames.front().particles(3));
    schema::write_clock(element, frames);
  }
}

void write_box(const hdf5::Writer& trajectory, const Record& record, std::span<const Frame> all,
               const ParticleShape& shape) {
  std::vector<std::string> boundary = record.boundary;
  boundary.resize(3, "none");
  const hdf5::Writer box = trajectory.group("box");
  box.attribute("dimension", 3);
  box.attribute("boundary", boundary);

  const std::vector<double> edges = box_in_space(record, shape);
  const std::size_t frames = all.size();
  std::vector<double> matrices(frames * 9, 0.0);
  for (std::size_t frame = 0; frame < frames; ++frame)
    for (std::size_t axis = 0; axis < 3; ++axis) matrices[9 * frame + 4 * axis] = edges[axis];
  const hdf5::Writer element = box.group("edges");
  element.numbers<double>("value", {frames, 3, 3}, matrices);
  schema::write_clock(element, all);
}

}  // namespace

Paths mdanalysis_paths(const Record&, const std::string& path) {
  return {without_ending(path, ".h5md") + ".h5md"};
}

void export_mdanalysis(const Record& record, const Paths& paths, const ParticleShape& shape) {
  std::vector<Frame> frames = frames_in_space(record);
  hdf5::write_whole_file(paths.front(), [&](const hdf5::Writer& root) {
    schema::write_convention(root, record.provenance);
    const hdf5::Writer trajectory = root.group("particles").group("trajectory");
    write_box(trajectory, record, frames, shape);
    write_observables(root.group("observables"), frames);
    keep_ids(frames);
    schema::write_trajectory(trajectory, frames, 3);
  });
}

}  // namespace sandglass
