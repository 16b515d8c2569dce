#include "sim/scene/method/family.hpp"
#include "sim/scene/read_sections.hpp"

#include <algorithm>

namespace sandglass {

namespace {
Words<std::string> preset_words() {
  Words<std::string> words;
  for (const std::string& name : preset_names()) words.emplace_back(name, name);
  return words;
}

bool holds(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string reason_against(const MethodFamily& family, const std::string& key, const std::string& preset) {
  for (const RefusedKeys& refused : family.refused)
    if (holds(refused.keys, key)) return refused.reason;
  std::vector<std::string> takers;
  for (const MethodFamily* other : method_families())
    if (holds(other->keys, key))
      for (const Preset& taker : other->presets) takers.push_back(taker.name);
  return "is for the method " + list_words(takers) + " only, not for '" + preset + "'; remove it";
}

bool is_neutral(const MethodFamily& family, const Table& table, const std::string& key) {
  const auto match = [&](const auto& entry) { return entry.first == key && table.says(key, entry.second); };
  return std::any_of(family.neutral.begin(), family.neutral.end(), match);
}

/// Where the preset itself is wrong nobody knows whose keys are meant.
void refuse_keys_of_others(Table& table, const Method& method) {
  const MethodFamily& family = family_of(method);
  for (const MethodFamily* other : method_families())
    for (const std::string& key : other->keys) {
      if (holds(family.keys, key)) continue;
      if (is_neutral(family, table, key) || !table.clean("preset"))
        table.skip(key);
      else
        table.refuse(key, reason_against(family, key, method.preset));
    }
}

void read_time_step(Table& table, TimeStep& time_step) {
  if (!table.has("time-step"))
    table.report_missing("time-step",
                         "give a time, { collisions-per-particle = 0.1 } or { cell-fraction = 0.5 }");
  if (!table.is("time-step", Node::Kind::table)) return table.read("time-step", time_step.fixed);
  Table inner = *table.table("time-step");
  inner.read("collisions-per-particle", time_step.collisions);
  inner.read("cell-fraction", time_step.cell_fraction);
  if (!inner.has("collisions-per-particle") && !inner.has("cell-fraction"))
    table.refuse("time-step",
                 "is a table without what a step follows from; give { collisions-per-particle = 0.1 } or "
                 "{ cell-fraction = 0.5 }, or a time: time-step = 0.1");
  inner.finish();
}
}  // namespace

void read_method(Table& table, Method& method) {
  std::string preset = method.preset;
  table.read_word("preset", "preset", preset, preset_words());
  choose(method, preset);
  family_of(method).read(table, method.options);
  refuse_keys_of_others(table, method);
  read_time_step(table, method.time_step);
  table.read("weight", method.weight);
  table.finish();
}

}  // namespace sandglass
