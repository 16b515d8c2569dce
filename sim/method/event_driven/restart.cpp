#include "sim/method/event_driven/restart.hpp"

#include "sim/base/error.hpp"

namespace sandglass::event_driven {

namespace {
const std::string kFolder = "event-driven/";

/// A number of a column's entry: a component of a vector, a field, or the entry itself.
template <class Entry, class Member>
auto component(Member Entry::*vector, int axis) {
  return [=](auto& entry) -> auto& { return (entry.*vector)[axis]; };
}
template <class Entry, class Number>
auto field(Number Entry::*number) {
  return [=](auto& entry) -> auto& { return entry.*number; };
}
constexpr auto itself = [](auto& entry) -> auto& { return entry; };

/// Visits every number of a particle's state that positions and velocities at one time do not hold.
template <int D, class SomeGas, class Visit>
void for_each_column(SomeGas& gas, Visit visit) {
  for (int axis = 0; axis < D; ++axis) {
    visit("position-" + std::to_string(axis), gas.particles, component(&Particle<D>::position, axis));
    visit("velocity-" + std::to_string(axis), gas.particles, component(&Particle<D>::velocity, axis));
  }
  visit("time", gas.particles, field(&Particle<D>::time));
  visit("changes", gas.particles, field(&Particle<D>::changes));
  for (const auto& [name, number] : {std::pair{"next", &Next::time}, std::pair{"contact", &Next::contact}})
    visit(name, gas.next, field(number));
  for (const auto& [name, number] :
       {std::pair{"partner", &Next::partner}, std::pair{"partner-changes", &Next::partner_changes},
        std::pair{"cell", &Next::cell}, std::pair{"exit", &Next::exit}})
    visit(name, gas.next, field(number));
  for (int axis = 0; axis < Spin<D>::SizeAtCompileTime; ++axis)
    visit(
        "spin-" + std::to_string(axis), gas.spins, [axis](auto& spin) -> auto& { return spin[axis]; });
  visit("last-contact", gas.last_contact, itself);
  visit("species", gas.species, itself);
  visit("ids", gas.ids, itself);
}

template <class Column, class Number>
std::vector<double> numbers(const Column& column, Number number) {
  std::vector<double> values;
  values.reserve(column.size());
  for (const auto& entry : column) values.push_back(static_cast<double>(number(entry)));
  return values;
}

template <class Column, class Number>
void restore(const std::string& name, const std::vector<double>& values, Column& column, Number number) {
  if (values.size() != column.size())
    throw InputError("the checkpoint's '" + name + "' does not fit its particles; the file is damaged");
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto& place = number(column[i]);
    place = static_cast<std::remove_reference_t<decltype(place)>>(values[i]);
  }
}

std::string agent_name(std::size_t agent) { return kFolder + "agent-" + std::to_string(agent); }

std::vector<double> numbers_of(const Progress& p) {
  return {p.now,
          p.origin,
          p.era.width,
          static_cast<double>(p.era.buckets),
          static_cast<double>(p.era.most_events),
          static_cast<double>(p.events),
          static_cast<double>(p.counts.crossings),
          static_cast<double>(p.counts.predictions),
          static_cast<double>(p.counts.guarded),
          static_cast<double>(p.counts.agent_events),
          static_cast<double>(p.exchanges)};
}

Progress progress_of(const std::vector<double>& numbers) {
  const auto whole = [&](std::size_t i) { return static_cast<std::uint64_t>(numbers.at(i)); };
  return {numbers.at(0),
          numbers.at(1),
          whole(5),
          {numbers.at(2), whole(3), whole(4)},
          {whole(6), whole(7), whole(8), whole(9)},
          whole(10)};
}
}  // namespace

template <int D>
Memory save_state(const Gas<D>& gas, const Agents<D>& agents, const Progress& progress) {
  Memory memory;
  for_each_column<D>(gas, [&](const std::string& name, const auto& column, auto number) {
    memory[kFolder + name] = numbers(column, number);
  });
  memory[kFolder + "progress"] = numbers_of(progress);
  for (std::size_t a = 0; a < agents.size(); ++a)
    if (std::vector<double> state = agents[a]->save(); !state.empty()) memory[agent_name(a)] = state;
  return memory;
}

template <int D>
void load_state(const Memory& memory, Gas<D>& gas, Agents<D>& agents, Progress& progress) {
  for_each_column<D>(gas, [&](const std::string& name, auto& column, auto number) {
    restore(kFolder + name, memory.at(kFolder + name), column, number);
  });
  progress = progress_of(memory.at(kFolder + "progress"));
  for (std::size_t a = 0; a < agents.size(); ++a)
    if (const auto state = memory.find(agent_name(a)); state != memory.end()) agents[a]->load(state->second);
}

template Memory save_state(const Gas<2>&, const Agents<2>&, const Progress&);
template Memory save_state(const Gas<3>&, const Agents<3>&, const Progress&);
template void load_state(const Memory&, Gas<2>&, Agents<2>&, Progress&);
template void load_state(const Memory&, Gas<3>&, Agents<3>&, Progress&);

}  // namespace sandglass::event_driven
