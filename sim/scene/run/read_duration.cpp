#include "sim/scene/read_sections.hpp"

namespace sandglass {

namespace {
void keep_one(Table& table, const std::vector<std::string>& given) {
  const std::string choice = "give exactly one of 'time', 'steps' or 'collisions-per-particle'";
  if (given.empty() && table.clean()) table.report_missing("time", choice);
  for (std::size_t i = 1; i < given.size(); ++i)
    table.refuse(given[i], "is given beside '" + given[0] + "'; " + choice);
}
}  // namespace

Duration read_duration(Table& table) {
  Duration duration;
  table.read("time", duration.time);
  table.read("steps", duration.steps);
  table.read("collisions-per-particle", duration.collisions);
  std::vector<std::string> given;
  for (const std::string key : {"time", "steps", "collisions-per-particle"})
    if (table.has(key)) given.push_back(key);
  table.finish();
  keep_one(table, given);
  return duration;
}

void read_cadence(Table& table, const std::string& key, std::optional<Cadence>& cadence) {
  std::optional<Table> inner = table.table(key);
  if (!inner) return;
  const Duration every = read_duration(*inner);
  if (!table.clean(key)) return;
  if (every.time) cadence = {Cadence::Unit::time, *every.time};
  if (every.steps) cadence = {Cadence::Unit::steps, static_cast<double>(*every.steps)};
  if (every.collisions) cadence = {Cadence::Unit::collisions, *every.collisions};
}

void read_cadence(Table& table, const std::string& key, Cadence& cadence) {
  std::optional<Cadence> given;
  read_cadence(table, key, given);
  if (given) cadence = *given;
}

}  // namespace sandglass
