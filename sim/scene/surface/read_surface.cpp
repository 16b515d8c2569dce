#include "sim/base/spelling.hpp"
#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// Lets a key be used with some rules only.
class RuleKeys {
 public:
  RuleKeys(Table& table, SurfaceKind rule) : table_(table), rule_(rule), known_(table.clean("rule")) {}

  /// True when the key is to be read; refuses it, when it is there, for another rule.
  bool allow(const std::string& key, const std::vector<SurfaceKind>& rules) {
    if (!known_) table_.skip(key);
    if (!known_) return false;
    if (std::count(rules.begin(), rules.end(), rule_) > 0) return true;
    std::vector<std::string> names;
    for (const SurfaceKind rule : rules) names.push_back(word_of(surface_kind_words(), rule));
    table_.refuse(key, "is used with rule = " + list_words(names) + " only; the rule here is '" +
                           word_of(surface_kind_words(), rule_) + "'");
    return false;
  }

 private:
  Table& table_;
  SurfaceKind rule_;
  bool known_;
};

void read_surface(Table& table, SurfaceRule& surface) {
  using enum SurfaceKind;
  table.read_word("rule", "wall rule", surface.rule, surface_kind_words());
  RuleKeys keys(table, surface.rule);
  if (keys.allow("restitution", {specular, bounce_back, random_tangential_sign}))
    table.read("restitution", surface.restitution);
  if (keys.allow("tangential-restitution", {specular}))
    table.read("tangential-restitution", surface.tangential_restitution);
  if (keys.allow("friction", {specular})) table.read("friction", surface.friction);
  if (keys.allow("probability", {bounce_back})) table.read("probability", surface.probability);
  if (keys.allow("temperature", {thermal}))
    table.require("temperature", surface.temperature, "granular temperature of the wall");
}
}  // namespace

void read_side(Table& table, int& axis, bool& high) {
  std::pair<int, bool> side{0, false};
  table.read_word("side", "side of the domain", side, wall_side_words());
  if (!table.has("side")) table.report_missing("side", "one of " + list_words(names_of(wall_side_words())));
  axis = side.first;
  high = side.second;
}

void read_wall(Table& table, Wall& wall) {
  read_side(table, wall.axis, wall.high);
  read_surface(table, wall.surface);
  table.read("velocity", wall.velocity);
  table.read("amplitude", wall.amplitude);
  table.read("frequency", wall.frequency);
  if (table.has("amplitude") && !table.has("frequency"))
    table.report_missing("frequency", "give oscillations per time beside 'amplitude'");
  if (!table.has("amplitude")) table.refuse("frequency", "is given without 'amplitude'; give both or none");
  table.finish();
}

void read_obstacle(Table& table, Obstacle& obstacle) {
  table.require("centre", obstacle.centre, "one coordinate for each axis, for example centre = [5.0, 5.0]");
  table.require("radius", obstacle.radius, "radius of the disk or sphere");
  read_surface(table, obstacle.surface);
  const std::string reason = "cannot be: an obstacle stands still; remove it";
  for (const std::string key : {"velocity", "amplitude", "frequency"}) table.refuse(key, reason);
  table.finish();
}

}  // namespace sandglass
