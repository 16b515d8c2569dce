#include "sim/record/atomic_file.hpp"
#include "sim/record/export/format.hpp"

#include <array>
#include <iterator>
#include <ranges>
#include <span>

#include <fmt/format.h>

// Extended XYZ, https://github.com/libAtoms/extxyz: a comment line with the box and the columns. The column
// names are those that OVITO knows: pos, velo, radius, id, mass; other columns keep their own. "species" is a chemical
// symbol here: X where all are alike, else one element for each species, with its index in species_index.

namespace sandglass {
namespace {

std::string name_of(const ColumnInfo& info) {
  return info.name == column::species.name ? "species_index" : info.name;
}

constexpr std::array elements{"H",  "He", "Li", "Be", "B",  "C",  "N", "O",  "F",  "Ne", "Na", "Mg",
                              "Al", "Si", "P",  "S",  "Cl", "Ar", "K", "Ca", "Sc", "Ti", "V",  "Cr"};

const char* element_of(std::span<const std::uint8_t> species, std::size_t particle) {
  if (species.empty()) return "X";
  return elements[species[particle] % elements.size()];
}

/// The radius says it already.
bool is_own_column(const NamedColumn& column) { return column.info.name != column::diameter.name; }

/// ":name:R:3" of each column.
std::string properties_of(const Columns& columns) {
  std::string text;
  for (const NamedColumn& column : columns.all() | std::views::filter(is_own_column))
    text += fmt::format(":{}:{}:{}", name_of(column.info), column.info.number == Number::real ? 'R' : 'I',
                        column.info.components);
  return text;
}

void put_values(std::string& text, const NamedColumn& column, std::size_t particle) {
  std::visit(
      [&](const auto& values) {
        for (std::size_t k = 0; k < column.info.components; ++k)
          fmt::format_to(std::back_inserter(text), " {}", values[particle * column.info.components + k]);
      },
      column.numbers);
}

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
      edges[0], edges[1], edges[2], periodic, properties_of(frame.columns), frame.time, frame.step);
}

std::string frame_text(const Record& record, const Frame& frame, const ParticleShape& shape) {
  const std::vector<double> position = in_space(frame.position, record.dimension);
  const std::vector<double> velocity = in_space(frame.velocity, record.dimension);
  const std::size_t count = position.size() / 3;
  const std::vector<double> diameters = diameters_of(frame, record.dimension, shape);
  const auto species = frame.columns.get(column::species);
  std::string text = fmt::format("{}\n", count) + comment_line(record, frame, shape);
  for (std::size_t particle = 0; particle < count; ++particle) {
    const double* x = &position[3 * particle];
    const double* v = &velocity[3 * particle];
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} {}", element_of(species, particle), x[0],
                   x[1], x[2], v[0], v[1], v[2], diameters[particle] / 2);
    for (const NamedColumn& column : frame.columns.all() | std::views::filter(is_own_column))
      put_values(text, column, particle);
    text += '\n';
  }
  return text;
}

}  // namespace

Paths xyz_paths(const Record&, const std::string& path) { return {path}; }

void export_xyz(const Record& record, const Paths& paths, const ParticleShape& shape) {
  AtomicFile file(paths.front());
  for (const Frame& frame : frames_of(record)) file.write(frame_text(record, frame, shape));
  file.commit();
}

}  // namespace sandglass
