#include "sim/record/export.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/record/export/format.hpp"

namespace sandglass {
namespace {

struct Entry {
  ExportFormat format;
  Paths (*paths)(const Record&, const std::string&);
  void (*write)(const Record&, const Paths&, const ParticleShape&);
  bool needs_trajectory;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{"vtp", "one .vtp file per frame and a .pvd that lists them, for ParaView"},
       vtp_paths,
       export_vtp,
       true},
      {{"xyz", "extended XYZ with every frame, for OVITO and ASE"}, xyz_paths, export_xyz, true},
      {{"mdanalysis", "H5MD padded to three dimensions, for MDAnalysis"},
       mdanalysis_paths,
       export_mdanalysis,
       true},
      {{"csv", "series, and beside them the estimates, as comma-separated tables"},
       csv_paths,
       export_csv,
       false}};
  return all;
}

const Entry& entry_of(const std::string& format) {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) {
    if (entry.format.name == format) return entry;
    names.push_back(entry.format.name);
  }
  throw InputError(unknown_word("export format", format, names));
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats = [] {
    std::vector<ExportFormat> list;
    for (const Entry& entry : entries()) list.push_back(entry.format);
    return list;
  }();
  return formats;
}

std::vector<std::string> export_paths(const Record& record, const std::string& format,
                                      const std::string& path) {
  const Entry& entry = entry_of(format);
  if (entry.needs_trajectory && frames_of(record).empty())
    throw InputError("the record holds no trajectory, which the format '" + format +
                     "' needs: add 'trajectory = { steps = 100 }' to [output] of the scene and run it again");
  return entry.paths(record, path);
}

std::vector<std::string> export_record(const Record& record, const std::string& format,
                                       const std::string& path, const ParticleShape& shape) {
  const Paths paths = export_paths(record, format, path);
  entry_of(format).write(record, paths, shape);
  return paths;
}

std::vector<double> in_space(const std::vector<double>& vectors, int dimension) {
  const auto width = static_cast<std::size_t>(dimension);
  const std::size_t count = vectors.size() / width;
  std::vector<double> padded(count * 3, 0.0);
  for (std::size_t index = 0; index < vectors.size(); ++index)
    padded[index / width * 3 + index % width] = vectors[index];
  return padded;
}

std::vector<Frame> frames_of(const Record& record) {
  if (!record.trajectory.empty() || !record.state) return record.trajectory;
  Frame frame = record.state->particles;
  frame.step = record.state->step;
  frame.time = record.state->time;
  return {frame};
}

std::vector<double> diameters_of(const Frame& frame, int dimension, const ParticleShape& shape) {
  const auto own = frame.columns.get(column::diameter);
  if (!own.empty()) return {own.begin(), own.end()};
  return std::vector<double>(frame.particles(dimension), shape.diameter);
}

std::vector<double> box_in_space(const Record& record, const ParticleShape& shape) {
  std::vector<double> edges = record.box_size;
  edges.resize(3, shape.diameter);
  return edges;
}

std::string without_ending(const std::string& path, const std::string& ending) {
  return path.ends_with(ending) ? path.substr(0, path.size() - ending.size()) : path;
}

}  // namespace sandglass
