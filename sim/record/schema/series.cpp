#include "sim/record/schema/series.hpp"

#include "sim/record/schema/names.hpp"
#include "sim/record/schema/quantity.hpp"

#include <algorithm>

namespace sandglass::schema {
namespace {

using Column = std::vector<const Series*>;  // one quantity, every replica

void require_whole(const Series& series) {
  if (series.time.size() != series.samples() ||
      series.value.size() != series.samples() * series.quantity.size())
    throw hdf5::Failure("series '" + series.quantity.name + "' does not have the size of its shape");
}

Column column_of(const std::vector<const SeriesList*>& replicas, std::size_t index) {
  Column column;
  for (const SeriesList* list : replicas) {
    const bool fits = list->size() == replicas.front()->size() &&
                      same((*list)[index].quantity, (*replicas.front())[index].quantity);
    if (!fits) throw hdf5::Failure("replicas hold different quantities");
    require_whole((*list)[index]);
    column.push_back(&(*list)[index]);
  }
  return column;
}

/// member[R][T * width], each replica padded with `fill` to `samples` samples.
template <class T>
std::vector<T> padded(const Column& column, std::vector<T> Series::*member, std::size_t samples,
                      std::size_t width, T fill) {
  std::vector<T> all(column.size() * samples * width, fill);
  auto row = all.begin();
  for (const Series* series : column) {
    std::copy((series->*member).begin(), (series->*member).end(), row);
    row += static_cast<std::ptrdiff_t>(samples * width);
  }
  return all;
}

void write_column(const hdf5::Writer& group, const Column& column) {
  const Quantity& quantity = column.front()->quantity;
  std::vector<std::uint64_t> counts;
  for (const Series* series : column) counts.push_back(series->samples());
  const std::size_t longest = *std::max_element(counts.begin(), counts.end());
  const hdf5::Extents extents = {column.size(), longest};

  write_quantity(group, quantity);
  group.numbers<std::uint64_t>(names::samples, {column.size()}, counts);
  group.numbers<double>(names::value, extents_of(extents, quantity),
                        padded(column, &Series::value, longest, quantity.size(), no_value),
                        hdf5::Packing::deflated);
  group.numbers<double>(names::time, extents, padded(column, &Series::time, longest, 1, no_value),
                        hdf5::Packing::deflated);
  group.numbers<std::uint64_t>(names::step, extents, padded(column, &Series::step, longest, 1, no_step),
                               hdf5::Packing::deflated);
}

/// The first `count` entries, of `width` numbers each, of row `replica` of rows of `longest` entries.
template <class T>
std::vector<T> row_of(const std::vector<T>& all, std::size_t replica, std::size_t longest, std::size_t count,
                      std::size_t width) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(replica * longest * width);
  return std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(count * width));
}

void read_column(const hdf5::Reader& group, std::vector<SeriesList>& lists) {
  const Quantity quantity = read_quantity(group);
  const auto counts = group.numbers<std::uint64_t>(names::samples, {lists.size()});
  const std::size_t longest = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  const hdf5::Extents extents = {lists.size(), longest};
  const auto values = group.numbers<double>(names::value, extents_of(extents, quantity));
  const auto times = group.numbers<double>(names::time, extents);
  const auto steps = group.numbers<std::uint64_t>(names::step, extents);
  for (std::size_t replica = 0; replica < lists.size(); ++replica) {
    const std::size_t count = counts[replica];
    lists[replica].push_back({quantity, row_of(steps, replica, longest, count, 1),
                              row_of(times, replica, longest, count, 1),
                              row_of(values, replica, longest, count, quantity.size())});
  }
}

}  // namespace

void write_series(const hdf5::Writer& group, const std::vector<const SeriesList*>& replicas) {
  if (replicas.empty()) return;
  const std::vector<std::string> links = links_of(*replicas.front());
  group.attribute(names::order, links);
  for (std::size_t index = 0; index < links.size(); ++index)
    write_column(group.group(links[index]), column_of(replicas, index));
}

std::vector<SeriesList> read_series(const hdf5::Reader& group, std::size_t replicas) {
  std::vector<SeriesList> lists(replicas);
  for (const std::string& link : group.words(names::order)) read_column(group.group(link), lists);
  return lists;
}

void write_observables(const hdf5::Writer& group, const SeriesList& replica) {
  const std::vector<std::string> links = links_of(replica);
  for (std::size_t index = 0; index < links.size(); ++index) {
    const Series& series = replica[index];
    const hdf5::Writer element = group.group(links[index]);
    element.attribute("units", series.quantity.units);
    element.numbers<double>(names::value, extents_of({series.samples()}, series.quantity), series.value,
                            hdf5::Packing::deflated);
    element.numbers<double>(names::time, {series.samples()}, series.time, hdf5::Packing::deflated);
    element.numbers<std::uint64_t>(names::step, {series.samples()}, series.step, hdf5::Packing::deflated);
  }
}

}  // namespace sandglass::schema
