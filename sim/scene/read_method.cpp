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
  table.read_word("preset", "preset", method.preset, preset_words());
  const Preset& preset = *find_preset(method.preset);
  method.contact_factor = preset.contact_factor;
  method.offset = preset.offset;
  table.read_word("contact-factor", "contact factor", method.contact_factor, contact_factor_words());
  table.read_word("density", "density estimate", method.density, density_words());
  table.read_word("offset", "offset", method.offset, offset_words());
  read_random_offset(table, method);
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
  read_policies(table, method);
  table.read("cells", method.cells);
  table.read("cell-size", method.cell_size);
  if (table.has("cells")) table.refuse("cell-size", "is given beside 'cells'; give one of them");
  read_time_step(table, method.time_step);
  table.read("weight", method.weight);
  table.finish();
}

}  // namespace sandglass
