#include "sim/record/schema/state.hpp"

#include "sim/record/schema/names.hpp"
#include "sim/record/schema/particles.hpp"
#include "sim/record/schema/quantity.hpp"
#include "sim/record/schema/series.hpp"

#include <cmath>

namespace sandglass::schema {

void write_scalars(const hdf5::Writer& group, const std::map<std::string, double>& scalars) {
  for (const auto& [name, scalar] : scalars) group.number<double>(link_of_name(name), scalar);
}

std::map<std::string, double> read_scalars(const hdf5::Reader& group) {
  std::map<std::string, double> scalars;
  for (const std::string& link : group.names()) scalars[name_of_link(link)] = group.number<double>(link);
  return scalars;
}

void write_replicas(const hdf5::Writer& group, const std::vector<Replica>& replicas) {
  std::vector<std::uint64_t> seeds;
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t index = 0; index < replicas.size(); ++index) {
    seeds.push_back(replicas[index].seed);
    for (const auto& [name, number] : replicas[index].counters)
      columns.try_emplace(name, replicas.size(), no_value).first->second[index] = number;
  }
  group.numbers<std::uint64_t>(names::seed, {seeds.size()}, seeds);
  const hdf5::Writer counter_group = group.group(names::counters);
  for (const auto& [name, column] : columns)
    counter_group.numbers<double>(link_of_name(name), {column.size()}, column);
}

std::vector<Replica> read_replicas(const hdf5::Reader& group) {
  std::vector<Replica> replicas;
  for (std::uint64_t number : group.numbers<std::uint64_t>(names::seed).values)
    replicas.push_back({number, {}, {}});
  const hdf5::Reader counter_group = group.group(names::counters);
  for (const std::string& link : counter_group.names()) {
    const auto column = counter_group.numbers<double>(link, {replicas.size()});
    for (std::size_t index = 0; index < column.size(); ++index)
      if (!std::isnan(column[index])) replicas[index].counters[name_of_link(link)] = column[index];
  }
  return replicas;
}

void write_state(const hdf5::Writer& group, const State& state, int dimension) {
  group.number<std::uint64_t>(names::step, state.step);
  group.number<double>(names::time, state.time);
  write_trajectory(group.group(names::particles), std::span<const Frame>(&state.particles, 1), dimension);
  write_series(group.group(names::series), {&state.series});
  write_scalars(group.group(names::counters), state.counters);
  const hdf5::Writer memory_group = group.group(names::memory);
  for (const auto& [name, values] : state.memory)
    memory_group.numbers<double>(link_of_name(name), {values.size()}, values);
}

State read_state(const hdf5::Reader& group, int dimension) {
  State state;
  state.step = group.number<std::uint64_t>(names::step);
  state.time = group.number<double>(names::time);
  const std::vector<Frame> frames = read_trajectory(group.group(names::particles), dimension);
  if (frames.size() != 1) group.fail(names::particles, "does not hold one frame");
  state.particles = frames.front();
  state.series = read_series(group.group(names::series), 1).front();
  state.counters = read_scalars(group.group(names::counters));
  const hdf5::Reader memory_group = group.group(names::memory);
  for (const std::string& link : memory_group.names())
    state.memory[name_of_link(link)] = memory_group.numbers<double>(link).values;
  return state;
}

}  // namespace sandglass::schema
