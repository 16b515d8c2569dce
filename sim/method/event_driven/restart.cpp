#include "sim/method/event_driven/restart.hpp"

#include "sim/base/error.hpp"

namespace sandglass::event_driven {

namespace {
template <class Column, class Read>
std::vector<double> numbers(const Column& column, Read read) {
  std::vector<double> values;
  values.reserve(column.size());
  for (const auto& entry : column) values.push_back(static_cast<double>(read(entry)));
  return values;
}

template <class Column, class Write>
void restore(const Memory& memory, const std::string& name, Column& column, Write write) {
  const std::vector<double>& values = memory.at(name);
  if (values.size() != column.size())
    throw InputError("the checkpoint's '" + name + "' does not fit its particles; the file is damaged");
  for (std::size_t i = 0; i < values.size(); ++i) write(column[i], values[i]);
}

/// Visits every number of a particle's state that positions and velocities at one time do not hold.
template <int D, class Visit>
void for_each_column(Visit visit) {
  for (int axis = 0; axis < D; ++axis) {
    visit.body(
        "event-driven/position-" + std::to_string(axis), [axis](auto& b) -> auto& {
          return b.position[axis];
        });
    visit.body(
        "event-driven/velocity-" + std::to_string(axis), [axis](auto& b) -> auto& {
          return b.velocity[axis];
        });
  }
  visit.body(
      "event-driven/time", [](auto& b) -> auto& { return b.time; });
  visit.body(
      "event-driven/changes", [](auto& b) -> auto& { return b.changes; });
  visit.next(
      "event-driven/next", [](auto& n) -> auto& { return n.time; });
  visit.next(
      "event-driven/contact", [](auto& n) -> auto& { return n.contact; });
  visit.next(
      "event-driven/partner", [](auto& n) -> auto& { return n.partner; });
  visit.next(
      "event-driven/partner-changes", [](auto& n) -> auto& { return n.partner_changes; });
  visit.next(
      "event-driven/cell", [](auto& n) -> auto& { return n.cell; });
  visit.next(
      "event-driven/exit", [](auto& n) -> auto& { return n.exit; });
}

template <int D>
struct Saver {
  const Gas<D>& gas;
  Memory& memory;
  template <class Field>
  void body(const std::string& name, Field field) {
    memory[name] = numbers(gas.bodies, field);
  }
  template <class Field>
  void next(const std::string& name, Field field) {
    memory[name] = numbers(gas.next, field);
  }
};

template <int D>
struct Loader {
  const Memory& memory;
  Gas<D>& gas;
  template <class Field>
  void body(const std::string& name, Field field) {
    restore(memory, name, gas.bodies, [field](auto& entry, double value) {
      field(entry) = static_cast<std::remove_reference_t<decltype(field(entry))>>(value);
    });
  }
  template <class Field>
  void next(const std::string& name, Field field) {
    restore(memory, name, gas.next, [field](auto& entry, double value) {
      field(entry) = static_cast<std::remove_reference_t<decltype(field(entry))>>(value);
    });
  }
};
}  // namespace

template <int D>
void save_gas(const Gas<D>& gas, Memory& memory) {
  for_each_column<D>(Saver<D>{gas, memory});
  const auto itself = [](auto value) { return value; };
  memory["event-driven/last-contact"] = numbers(gas.last_contact, itself);
  memory["event-driven/species"] = numbers(gas.species, itself);
  memory["event-driven/ids"] = numbers(gas.ids, itself);
  for (int axis = 0; axis < Spin<D>::SizeAtCompileTime; ++axis)
    memory["event-driven/spin-" + std::to_string(axis)] =
        numbers(gas.spins, [axis](const Spin<D>& spin) { return spin[axis]; });
}

template <int D>
void load_gas(const Memory& memory, Gas<D>& gas) {
  for_each_column<D>(Loader<D>{memory, gas});
  const auto itself = [](auto& entry, double value) {
    entry = static_cast<std::remove_reference_t<decltype(entry)>>(value);
  };
  restore(memory, "event-driven/last-contact", gas.last_contact, itself);
  restore(memory, "event-driven/species", gas.species, itself);
  restore(memory, "event-driven/ids", gas.ids, itself);
  for (int axis = 0; axis < Spin<D>::SizeAtCompileTime; ++axis)
    restore(memory, "event-driven/spin-" + std::to_string(axis), gas.spins,
            [axis](Spin<D>& spin, double value) { spin[axis] = value; });
}

template void save_gas(const Gas<2>&, Memory&);
template void save_gas(const Gas<3>&, Memory&);
template void load_gas(const Memory&, Gas<2>&);
template void load_gas(const Memory&, Gas<3>&);

}  // namespace sandglass::event_driven
