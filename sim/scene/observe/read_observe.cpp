#include "sim/base/spelling.hpp"
#include "sim/scene/observe/observers.hpp"
#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
Words<std::string> observer_words() {
  Words<std::string> words;
  for (const std::string& name : observer_names()) words.emplace_back(name, name);
  return words;
}

void read_own_keys(Table& table, Observe& observe) {
  if (observer_uses(observe.what, "axis")) table.read_word("axis", "axis", observe.axis, axis_words());
  if (observer_uses(observe.what, "position"))
    table.require("position", observe.position, "where the plane stands on the axis");
  if (observes_distances(observe.what))
    table.require("range", observe.range, "first and last distance, for example range = [0.0, 5.0]");
  else if (observer_uses(observe.what, "range"))
    table.read("range", observe.range);
  if (observer_uses(observe.what, "bins")) table.read("bins", observe.bins);
  if (observer_uses(observe.what, "grid"))
    table.require("grid", observe.grid, "bins along each axis, for example grid = [1, 32]");
}
}  // namespace

void read_observe(Table& table, Observe& observe) {
  table.read_word("what", "observer", observe.what, observer_words());
  if (!table.has("what")) table.report_missing("what", "one of " + list_words(observer_names()));
  read_cadence(table, "every", observe.cadence);
  read_cadence(table, "start", observe.start);
  read_own_keys(table, observe);
  const std::string reason = "is not used by the observer '" + observe.what + "'; remove it";
  for (const std::string key : {"axis", "position", "range", "bins", "grid"}) {
    if (observe.what.empty())
      table.skip(key);
    else if (!observer_uses(observe.what, key))
      table.refuse(key, reason);
  }
  table.finish();
}

}  // namespace sandglass
