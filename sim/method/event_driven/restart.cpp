#include "sim/method/event_driven/restart.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"

#include <algorithm>
#include <limits>

namespace sandglass::event_driven {

namespace {
const std::string kFolder = "event-driven/";
constexpr double kFar = 1e100;

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
    using Place = std::remove_reference_t<decltype(place)>;
    if constexpr (std::is_integral_v<Place>)
      place = static_cast<Place>(saved_count(
          values[i], name.c_str(), std::min(0x1p53, static_cast<double>(std::numeric_limits<Place>::max()))));
    else
      place = values[i];
  }
}

/// Contacts of which a collapse guard knows begin with it where it is set later, and end with it.
bool is_of_guard(const std::string& name, const std::vector<double>& values, std::size_t particles) {
  return name == "last-contact" && (values.empty() || particles == 0);
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
  const auto whole = [&](std::size_t i) { return saved_count(numbers.at(i)); };
  return {numbers.at(0),
          numbers.at(1),
          whole(5),
          {numbers.at(2), whole(3), whole(4)},
          {whole(6), whole(7), whole(8), whole(9)},
          whole(10)};
}
}  // namespace

template <int D>
void require_sound(const Gas<D>& gas, const Cells<D>& cells, std::size_t agents, std::size_t species,
                   const Progress& progress) {
  const double now = saved_number(progress.now, 0, kFar, "the time");
  saved_number(progress.origin, 0, kFar, "the time");
  if (!(progress.era.width > 0)) refuse_saved("the width of a bucket");
  saved_count(static_cast<double>(progress.era.buckets), "the number of buckets", 256 + 2.0 * gas.size());
  for (std::uint32_t i = 0; i < gas.size(); ++i) {
    const Particle<D>& particle = gas.particles[i];
    for (const double number : particle.position) saved_number(number, -kFar, kFar, "a position");
    for (const double number : particle.velocity) saved_number(number, -kFar, kFar, "a velocity");
    saved_number(particle.time, -kFar, kFar, "the time of a particle");
    if (gas.kind(i) >= species) refuse_saved("a species that the scene does not have");
    const Next& next = gas.next[i];
    const double slack = 1e-9 * now;
    saved_number(next.time, now - slack, HUGE_VAL, "the time of an event");
    saved_number(next.contact, next.time, HUGE_VAL, "the time of a contact");
    const bool known = next.partner < gas.size() ||
                       (next.partner >= kFirstAgent && next.partner - kFirstAgent < agents) ||
                       (next.partner == kNobody && next.contact == HUGE_VAL);
    if (!known) refuse_saved("the partner of a contact");
    if (!cells.has(next.cell)) refuse_saved("the cell of a particle");
    if (next.exit >= 2 * D) refuse_saved("the side by which a particle leaves its cell");
  }
}

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
    const std::vector<double>& values = memory.at(kFolder + name);
    if (!is_of_guard(name, values, column.size())) restore(kFolder + name, values, column, number);
  });
  progress = progress_of(memory.at(kFolder + "progress"));
  for (std::size_t a = 0; a < agents.size(); ++a)
    if (const auto state = memory.find(agent_name(a)); state != memory.end()) agents[a]->load(state->second);
}

template Memory save_state(const Gas<2>&, const Agents<2>&, const Progress&);
template Memory save_state(const Gas<3>&, const Agents<3>&, const Progress&);
template void load_state(const Memory&, Gas<2>&, Agents<2>&, Progress&);
template void load_state(const Memory&, Gas<3>&, Agents<3>&, Progress&);
template void require_sound(const Gas<2>&, const Cells<2>&, std::size_t, std::size_t, const Progress&);
template void require_sound(const Gas<3>&, const Cells<3>&, std::size_t, std::size_t, const Progress&);

}  // namespace sandglass::event_driven
