#include "sim/record/schema/columns.hpp"

#include "sim/record/schema/names.hpp"
#include "sim/record/schema/quantity.hpp"

#include <algorithm>
#include <type_traits>

namespace sandglass::schema {
namespace {

/// Calls `use` with the type that holds such numbers, as a std::type_identity.
template <class Use>
void with_type(Number number, Use use) {
  switch (number) {
    case Number::byte:
      return use(std::type_identity<std::uint8_t>());
    case Number::whole:
      return use(std::type_identity<std::uint64_t>());
    case Number::real:
      return use(std::type_identity<double>());
  }
}

template <class T>
constexpr T no_number_of() {
  if constexpr (std::is_same_v<T, double>) return no_value;
  if constexpr (std::is_same_v<T, std::uint64_t>) return no_number;
  if constexpr (std::is_same_v<T, std::uint8_t>) return no_byte;
}

template <class T>
void write_numbers(const hdf5::Writer& element, const ColumnInfo& info, std::span<const Frame> frames,
                   std::size_t most) {
  const std::size_t row = most * info.components;
  const T absent = no_number_of<T>();
  std::vector<T> all(frames.size() * row, absent);
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    if (const NamedColumn* column = frames[frame].columns.find(info))
      std::ranges::copy(std::get<std::vector<T>>(column->numbers),
                        all.begin() + static_cast<std::ptrdiff_t>(frame * row));
  hdf5::Extents extents = {frames.size(), most};
  if (info.vector) extents.push_back(info.components);
  element.numbers<T>(names::value, extents, all, hdf5::Packing::plain, &absent);
}

template <class T>
void read_numbers(const hdf5::Reader& element, ColumnInfo info, std::span<const std::uint64_t> counts,
                  std::span<Frame> frames) {
  const hdf5::Array<T> stored = element.numbers<T>(names::value);
  const hdf5::Extents& extents = stored.extents;
  const std::size_t most = counts.empty() ? 0 : *std::ranges::max_element(counts);
  if (extents.size() < 2 || extents.size() > 3 || extents[0] != counts.size() || extents[1] != most)
    element.fail(names::value, "does not hold one value per particle and frame");
  info.vector = extents.size() == 3;
  info.components = info.vector ? extents[2] : 1;
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const auto begin = stored.values.begin() + static_cast<std::ptrdiff_t>(frame * most * info.components);
    const auto end = begin + static_cast<std::ptrdiff_t>(counts[frame] * info.components);
    frames[frame].columns.set({info, std::vector<T>(begin, end)});
  }
}

}  // namespace

std::vector<ColumnInfo> columns_of(std::span<const Frame> frames) {
  std::vector<ColumnInfo> columns;
  for (const Frame& frame : frames)
    for (const NamedColumn& column : frame.columns.all())
      if (std::ranges::none_of(columns, [&](const auto& known) { return known.name == column.info.name; }))
        columns.push_back(column.info);
  for (const Frame& frame : frames)
    for (const ColumnInfo& info : columns)
      if (!frame.position.empty() && frame.columns.find(info) == nullptr)
        throw hdf5::Failure("only some frames hold the particle column '" + info.name + "'");
  return columns;
}

void write_column(const hdf5::Writer& element, const ColumnInfo& info, std::span<const Frame> frames,
                  std::size_t most) {
  element.attribute(names::units, info.units);
  with_type(info.number,
            [&]<class T>(std::type_identity<T>) { write_numbers<T>(element, info, frames, most); });
}

std::vector<std::string> column_links(const hdf5::Reader& group) {
  std::vector<std::string> links = group.names();
  std::erase_if(links, [&group](const std::string& link) {
    return link == names::position || link == names::velocity || link == names::count || link == names::box ||
           !group.group(link).has(names::value);
  });
  return links;
}

void read_column(const hdf5::Reader& group, const std::string& link, std::span<const std::uint64_t> counts,
                 std::span<Frame> frames) {
  const hdf5::Reader element = group.group(link);
  const Number number = element.number_of(names::value);
  const ColumnInfo info{name_of_link(link), element.word(names::units), number, 1, false, 0};
  with_type(number, [&]<class T>(std::type_identity<T>) { read_numbers<T>(element, info, counts, frames); });
}

}  // namespace sandglass::schema
