#include "sim/scene/catalogue.hpp"
#include "sim/scene/read_sections.hpp"

namespace sandglass {

namespace {
Words<std::string> preset_words() {
  Words<std::string> words;
  for (const std::string& name : preset_names()) words.emplace_back(name, name);
  return words;
}

void read_random_offset(Table& table, Method& method) {
  if (method.offset == Offset::random) {
    method.random_offset = default_random_offset;
    table.read("random-offset", method.random_offset);
  } else if (!table.clean("offset")) {
    table.skip("random-offset");
  } else {
    table.refuse("random-offset", "is used with offset = \"random\" only; the offset here is \"" +
                                      word_of(offset_words(), method.offset) + '"');
  }
}

void read_policies(Table& table, Method& method) {
  const Preset& preset = *find_preset(method.preset);
  method.contact_factor = preset.contact_factor;
  method.offset = preset.offset;
  table.read_word("contact-factor", "contact factor", method.contact_factor, contact_factor_words());
  table.read_word("density", "density estimate", method.density, density_words());
  table.read_word("offset", "offset", method.offset, offset_words());
  read_random_offset(table, method);
}

void refuse_policies(Table& table) {
  for (const std::string key : {"contact-factor", "density", "offset", "random-offset"})
    table.refuse(key, "is not used by the method 'event-driven', whose collisions are exact; remove it");
  for (const std::string key : {"cells", "cell-size"})
    table.refuse(key, "is chosen by the method 'event-driven' itself; remove it");
}

void read_cells(Table& table, Method& method) {
  table.read("cells", method.cells);
  table.read("cell-size", method.cell_size);
  if (table.has("cells")) table.refuse("cell-size", "is given beside 'cells'; give one of them");
}

/// A number that one guard needs and the others do not use.
void read_guard_number(Table& table, const std::string& key, CollapseGuard guard, CollapseGuard user,
                       double& target, const std::string& remedy) {
  if (!table.clean("collapse-guard"))
    table.skip(key);
  else if (guard == user)
    table.require(key, target, remedy);
  else
    table.refuse(key, "is used with collapse-guard = \"" + word_of(guard_words(), user) +
                          "\" only; the guard here is \"" + word_of(guard_words(), guard) + '"');
}

void read_guard(Table& table, Method& method) {
  table.read_word("collapse-guard", "collapse guard", method.guard, guard_words());
  read_guard_number(table, "contact-time", method.guard, CollapseGuard::contact_time, method.contact_time,
                    "time after a collision for which the next is elastic");
  read_guard_number(table, "reference-speed", method.guard, CollapseGuard::velocity_dependent,
                    method.reference_speed, "normal speed below which the restitution goes to 1");
}

void refuse_guard(Table& table) {
  for (const std::string key : {"collapse-guard", "contact-time", "reference-speed"})
    if (table.clean("preset"))
      table.refuse(key, "is for the method 'event-driven' only, where collapse can happen; remove it");
    else
      table.skip(key);
}

void read_time_step(Table& table, TimeStep& time_step) {
  if (!table.has("time-step"))
    table.report_missing("time-step", "give a time, or { collisions-per-particle = 0.1 }");
  if (!table.is("time-step", Node::Kind::table)) return table.read("time-step", time_step.fixed);
  Table inner = *table.table("time-step");
  inner.require("collisions-per-particle", time_step.collisions,
                "collisions of a particle in one step, for example 0.1");
  inner.finish();
}
}  // namespace

void read_method(Table& table, Method& method) {
  table.read_word("preset", "preset", method.preset, preset_words());
  if (method.preset == event_driven_preset) {
    refuse_policies(table);
    read_guard(table, method);
  } else {
    read_policies(table, method);
    read_cells(table, method);
    refuse_guard(table);
  }
  read_time_step(table, method.time_step);
  table.read("weight", method.weight);
  table.finish();
}

}  // namespace sandglass
