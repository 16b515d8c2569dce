#include "sim/record/atomic_file.hpp"
#include "sim/record/export/base64.hpp"
#include "sim/record/export/format.hpp"

#include <bit>
#include <filesystem>
#include <numeric>

#include <fmt/format.h>

// VTK XML PolyData, https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html: points with one
// vertex cell each (without cells ParaView draws nothing), arrays inline in base64, so that every double is
// exact.

namespace sandglass {
namespace {

constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

template <class T>
std::string array(const char* type, const char* name, int components, const std::vector<T>& values) {
  const std::uint64_t bytes = values.size() * sizeof(T);
  std::string raw(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  raw.append(reinterpret_cast<const char*>(values.data()), bytes);
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n", type,
      name, components, base64(raw));
}

std::string escaped(const std::string& text) {
  std::string out;
  for (char letter : text) {
    if (letter == '&')
      out += "&amp;";
    else if (letter == '<')
      out += "&lt;";
    else if (letter == '"')
      out += "&quot;";
    else
      out += letter;
  }
  return out;
}

std::string column_array(const NamedColumn& column) {
  static constexpr const char* types[] = {"UInt8", "UInt64", "Float64"};  // as in Number
  const auto write = [&column](const auto& values) {
    return array(types[static_cast<int>(column.info.number)], escaped(column.info.name).c_str(),
                 static_cast<int>(column.info.components), values);
  };
  return std::visit(write, column.numbers);
}

std::string polydata(const Frame& frame, int dimension, const ParticleShape& shape) {
  const std::vector<double> points = in_space(frame.position, dimension);
  const std::size_t count = points.size() / 3;
  std::vector<std::int64_t> connectivity(count);
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  std::vector<std::int64_t> offsets(count);
  std::iota(offsets.begin(), offsets.end(), std::int64_t{1});

  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\">\n",
      byte_order, count, count);
  text += "<PointData Scalars=\"diameter\" Vectors=\"velocity\">\n";
  text += array("Float64", "velocity", 3, in_space(frame.velocity, dimension));
  text += array("Float64", "diameter", 1, diameters_of(frame, dimension, shape));
  for (const NamedColumn& column : frame.columns.all())
    if (column.info.name != column::diameter.name) text += column_array(column);
  text += "</PointData>\n<Points>\n" + array("Float64", "position", 3, points) + "</Points>\n<Verts>\n";
  text += array("Int64", "connectivity", 1, connectivity) + array("Int64", "offsets", 1, offsets);
  text += "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return text;
}

void write_whole(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

Paths vtp_paths(const Record& record, const std::string& path) {
  const std::string stem = without_ending(path, ".pvd");
  Paths paths;
  for (std::size_t frame = 0; frame < frames_of(record).size(); ++frame)
    paths.push_back(fmt::format("{}-{:06}.vtp", stem, frame));
  paths.push_back(stem + ".pvd");
  return paths;
}

void export_vtp(const Record& record, const Paths& paths, const ParticleShape& shape) {
  std::string list = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  const std::vector<Frame> frames = frames_of(record);
  for (std::size_t index = 0; index < frames.size(); ++index) {
    const Frame& frame = frames[index];
    write_whole(paths[index], polydata(frame, record.dimension, shape));
    list += fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", frame.time,
                        escaped(std::filesystem::path(paths[index]).filename()));
  }
  write_whole(paths.back(), list + "</Collection>\n</VTKFile>\n");
}

}  // namespace sandglass
