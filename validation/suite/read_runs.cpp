#include "sim/base/spelling.hpp"
#include "sim/run/run.hpp"
#include "validation/suite/read_parts.hpp"

#include <algorithm>

// What a case runs beside its matrix: tiers, sweeps, planted faults.

namespace sandglass {

namespace {
void read_factors(Table& table, const Node& node, Factors& factors) {
  std::optional<Table> inner = table.table("factor");
  if (!inner) return;
  factors.place = entry_of(node, "factor")->place;
  for (const auto& [key, target] :
       {std::pair{"replicas", &factors.replicas}, {"duration", &factors.duration}, {"size", &factors.size}}) {
    inner->read(key, *target);
    if (!(*target > 0)) inner->refuse(key, "must be above zero");
  }
  inner->finish();
}

/// The pairs at which the case makes the check, out of those that a planted fault chooses.
std::vector<Mutant> spread(const Mutant& mutant, const Selection& where, const Case& subject) {
  std::vector<Mutant> all;
  for (const Variant& variant : subject.variants)
    for (const Point& point : subject.points) {
      if (!where.holds(point.name, variant.name) || !subject.use_of(mutant.check, point.name, variant.name))
        continue;
      Mutant& one = all.emplace_back(mutant);
      one.variant = variant.name;
      one.point = point.name;
    }
  return all;
}

class MutantReader {
 public:
  MutantReader(const std::string& file, const Choices& choices, Case& result)
      : file_(file), choices_(choices), result_(result) {}

  /// One planted fault, or one for each 'at', which says what the keys beside it leave open.
  void read(Table& table, const Node& node) {
    if (!table.has("at")) return read_one(table, node);
    const std::vector<Table> tables = table.tables("at");
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const Node whole = completed(entry_of(node, "at")->items[i], node);
      Table inner(whole, item_path(table.path_of("at"), i), *choices_.diagnostics);
      read_one(inner, whole);
      inner.finish();
    }
    for (const Node& item : node.items) table.skip(item.key);
  }

 private:
  /// The table with what it lacks from the one around it.
  static Node completed(Node table, const Node& outer) {
    for (const Node& item : outer.items)
      if (item.key != "at" && !entry_of(table, item.key)) table.items.push_back(item);
    return table;
  }

  void read_one(Table& table, const Node& node) {
    Diagnostics& diagnostics = *choices_.diagnostics;
    const auto faults =
        read_choice(table, "mutation", "planted fault", choices_of(planted_faults()), diagnostics);
    const auto checks = read_choice(table, "check", "check", choices_of(all_checks()), diagnostics);
    Selection where;
    choices_.read(table, where);
    for (const std::string key : {"mutation", "check", "variants", "points"})
      if (!table.has(key))
        table.report_missing(key, "a planted fault names what is planted, who must see it, and where");
    Mutant mutant;
    if (std::optional<Table> numbers = table.table("numbers"))
      for (const Node& entry : entry_of(node, "numbers")->items)
        numbers->read(entry.key, mutant.numbers[entry.key]);
    mutant.set = read_set(table, node, "set", file_);
    if (!table.clean()) return;
    for (const std::string& fault : faults)
      for (const std::string& check : checks) {
        mutant.fault = fault;
        mutant.check = check;
        add(table, mutant, where);
      }
  }

  void add(Table& table, const Mutant& mutant, const Selection& where) {
    const std::vector<Mutant> all = spread(mutant, where, result_);
    if (all.empty())
      choices_.diagnostics->report(
          table.path_of("check"),
          "the case does not make the check '" + mutant.check + "' there: add it or choose other points");
    for (const Mutant& one : all) {
      if (one.numbers.empty() &&
          result_.use_of(one.check, one.point, one.variant)->known_limit(one.point, one.variant))
        choices_.diagnostics->report(
            table.path_of("check"),
            "the honest run at point '" + one.point + "' of variant '" + one.variant +
                "' is a known limit and fails as well: choose another, or give 'numbers' that it passes");
      result_.mutants.push_back(one);
    }
  }

  const std::string& file_;
  const Choices& choices_;
  Case& result_;
};
}  // namespace

void read_tiers(Table& root, const Node& document, const std::string& file, const Choices& choices,
                Case& result) {
  read_each(root, document, "tier", [&](Table& table, const Node& node) {
    Tier& tier = result.tiers.emplace_back();
    table.require("name", tier.name, list_words(tier_names()));
    if (std::ranges::find(tier_names(), tier.name) == tier_names().end() && table.clean("name"))
      choices.diagnostics->report(table.path_of("name"), unknown_word("tier", tier.name, tier_names()));
    table.read("sweeps", tier.sweeps);
    choices.read(table, tier.where);
    read_each(table, node, "change", [&](Table& inner, const Node& entry) {
      TierChange& change = tier.changes.emplace_back();
      choices.read(inner, change.where);
      change.set = read_set(inner, entry, "set", file);
      read_factors(inner, entry, change.set.factors);
    });
  });
}

void read_sweeps(Table& root, const Node& document, const std::string& file, const Choices& choices,
                 Case& result) {
  const auto named = [&](Table& table, const std::string& key, const std::string& kind, std::string& word,
                         const std::vector<Choice>& allowed) {
    table.require(key, word, "the name of a " + kind);
    if (!word.empty()) report_idle({word}, kind, allowed, table.path_of(key), *choices.diagnostics);
  };
  read_each(root, document, "sweep", [&](Table& table, const Node& node) {
    Sweep& sweep = result.sweeps.emplace_back();
    table.require("knob", sweep.knob, "a short name, for example 'time-step'");
    table.require("label", sweep.label, "the axis label with units");
    named(table, "variant", "variant", sweep.variant, choices_of(result.variants));
    named(table, "point", "point", sweep.point, choices_of(result.points));
    named(table, "check", "check", sweep.use.check, choices_of(all_checks()));
    table.require("quantity", sweep.quantity, "what the check's value is");
    table.require("reference-source", sweep.reference_source, "what the reference run is");
    table.read("expected-order", sweep.expected_order);
    sweep.reference = read_set(table, node, "reference", file);
    read_each(table, node, "at", [&](Table& inner, const Node& entry) {
      SweepPoint& point = sweep.points.emplace_back();
      inner.require("knob", point.knob, "the value on the axis");
      point.set = read_set(inner, entry, "set", file);
    });
  });
}

void read_mutants(Table& root, const Node& document, const std::string& file, const Choices& choices,
                  Case& result) {
  MutantReader reader(file, choices, result);
  read_each(root, document, "mutant", [&](Table& table, const Node& node) { reader.read(table, node); });
}

}  // namespace sandglass
