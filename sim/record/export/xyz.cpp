#include "sim/record/atomic_file.hpp"
#include "sim/record/export/format.hpp"

#include <iterator>

#include <fmt/format.h>

// Extended XYZ, https://github.com/libAtoms/extxyz: a comment line with the box and the columns. The column
// names are those that OVITO knows: pos, velo, radius, id.

namespace sandglass {
namespace {

std::string comment_line(const Record& record, const Frame& frame, const ParticleShape& shape) {
  const std::vector<double> edges = box_in_space(record, shape);
  std::string periodic;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool around = axis < record.boundary.size() && record.boundary[axis] == "periodic";
    periodic += std::string(axis == 0 ? "" : " ") + (around ? "T" : "F");
  }
  return fmt::format(
      "Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"0 0 0\" pbc=\"{}\" "
      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1{} Time={} Step={}\n",
      edges[0], edges[1], edges[2], periodic, frame.id.empty() ? "" : ":id:I:1", frame.time, frame.step);
}

std::string frame_text(const Record& record, const Frame& frame, const ParticleShape& shape) {
  const std::vector<double> position = in_space(frame.position, record.dimension);
  const std::vector<double> velocity = in_space(frame.velocity, record.dimension);
  const std::size_t count = position.size() / 3;
  std::string text = fmt::format("{}\n", count) + comment_line(record, frame, shape);
  for (std::size_t particle = 0; particle < count; ++particle) {
    const double* x = &position[3 * particle];
    const double* v = &velocity[3 * particle];
    fmt::format_to(std::back_inserter(text), "X {} {} {} {} {} {} {}", x[0], x[1], x[2], v[0], v[1], v[2],
                   shape.diameter / 2);
    if (!frame.id.empty()) fmt::format_to(std::back_inserter(text), " {}", frame.id[particle]);
    text += '\n';
  }
  return text;
}

}  // namespace

Paths export_xyz(const Record& record, const std::string& path, const ParticleShape& shape) {
  AtomicFile file(path);
  for (const Frame& frame : record.trajectory) file.write(frame_text(record, frame, shape));
  file.commit();
  return {path};
}

}  // namespace sandglass
