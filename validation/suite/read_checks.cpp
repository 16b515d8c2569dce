#include "sim/base/spelling.hpp"
#include "validation/suite/read_parts.hpp"

#include <algorithm>

namespace sandglass {

namespace {
/// Reads one [[check]] and what it says of each of its checks.
class CheckReader {
 public:
  CheckReader(const VariantLibrary& library, const Choices& choices, Case& result)
      : library_(library), choices_(choices), result_(result) {}

  void read(Table& table, const Node& node) {
    const std::vector<std::string> checks =
        read_choice(table, "check", "check", choices_of(all_checks()), *choices_.diagnostics);
    if (!table.has("check")) table.report_missing("check", "a name out of 'list checks'");
    CheckUse use;
    table.read("claim", use.claim);
    read_settings(table, node, checks, use);
    read_limits(table, node, checks, use);
    const std::vector<Selection> lifted = read_lifted(table, node);
    std::vector<CheckUse> parts = read_parts(table, node, checks, use);
    if (!table.has("at")) parts = {use};
    for (const std::string& check : checks)
      for (CheckUse part : parts) {
        part.check = check;
        add_shared_limits(part, lifted);
        add(std::move(part), table);
      }
  }

 private:
  void read_settings(Table& table, const Node& node, const std::vector<std::string>& checks, CheckUse& use) {
    table.read("systematic", use.settings.systematic);
    table.read("resolution", use.settings.resolution);
    table.read("reason", use.settings.reason);
    choices_.read(table, use.where);
    read_numbers(table, node, "numbers", checks, *choices_.diagnostics, use.settings.numbers);
  }

  void read_limits(Table& table, const Node& node, const std::vector<std::string>& checks, CheckUse& use) {
    read_each(table, node, "known-limit", [&](Table& inner, const Node& entry) {
      KnownLimit& limit = use.limits.emplace_back();
      inner.require("reason", limit.reason, "what the source says");
      read_numbers(inner, entry, "instead", checks, *choices_.diagnostics, limit.instead);
      choices_.read(inner, limit.where);
    });
  }

  std::vector<Selection> read_lifted(Table& table, const Node& node) {
    std::vector<Selection> lifted;
    read_each(table, node, "lifted-limit", [&](Table& inner, const Node&) {
      std::string reason;
      inner.require("reason", reason, "why the shared limit does not hold here");
      choices_.read(inner, lifted.emplace_back());
    });
    return lifted;
  }

  /// The check once for every 'at', each with its own points, variants and numbers.
  std::vector<CheckUse> read_parts(Table& table, const Node& node, const std::vector<std::string>& checks,
                                   const CheckUse& whole) {
    std::vector<CheckUse> parts;
    read_each(table, node, "at", [&](Table& inner, const Node& entry) {
      CheckUse part = whole;
      part.where = {};
      read_settings(inner, entry, checks, part);
      const bool some =
          narrow(part.where.points, whole.where.points) && narrow(part.where.variants, whole.where.variants);
      if (!some && inner.clean())
        choices_.diagnostics->report(inner.path_of(""), "chooses nothing of what its [[check]] chooses");
      parts.push_back(std::move(part));
    });
    return parts;
  }

  /// Keeps what both lists hold, where an empty one means all; false when that is nothing.
  static bool narrow(std::vector<std::string>& names, const std::vector<std::string>& outer) {
    if (outer.empty()) return true;
    if (names.empty()) {
      names = outer;
      return true;
    }
    std::erase_if(names,
                  [&](const std::string& name) { return std::ranges::find(outer, name) == outer.end(); });
    return !names.empty();
  }

  void add_shared_limits(CheckUse& use, const std::vector<Selection>& lifted) const {
    for (const SharedLimit& shared : library_.limits) {
      if (!chosen(shared.checks, {use.check, {}})) continue;
      const Selection where{choose(shared.points, choices_.points),
                            choose(shared.variants, choices_.variants)};
      if (where.points.empty() || where.variants.empty()) continue;
      use.limits.push_back({where, shared.reason, shared.instead, lifted});
    }
  }

  /// A check is made somewhere, and once.
  void add(CheckUse use, Table& table) {
    bool made = false;
    for (const Variant& variant : result_.variants)
      for (const Point& point : result_.points) {
        if (!use.where.holds(point.name, variant.name) || !result_.runs(point.name, variant.name)) continue;
        made = true;
        if (!result_.use_of(use.check, point.name, variant.name) || !table.clean("check")) continue;
        choices_.diagnostics->report(
            table.path_of("check"), "the check '" + use.check + "' is made twice at point '" + point.name +
                                        "' of variant '" + variant.name + "': narrow 'points' or 'variants'");
      }
    if (!made && table.clean())
      choices_.diagnostics->report(table.path_of("check"),
                                   "the check '" + use.check +
                                       "' is made nowhere: no variant that it chooses runs at a "
                                       "point that it chooses");
    result_.checks.push_back(std::move(use));
  }

  const VariantLibrary& library_;
  const Choices& choices_;
  Case& result_;
};
}  // namespace

void read_checks(Table& root, const Node& document, const VariantLibrary& library, const Choices& choices,
                 Case& result) {
  CheckReader reader(library, choices, result);
  read_each(root, document, "check", [&](Table& table, const Node& node) { reader.read(table, node); });
}

}  // namespace sandglass
