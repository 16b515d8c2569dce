#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/scene/text/table.hpp"
#include "validation/suite/case.hpp"
#include "validation/suite/case_rules.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace sandglass {

namespace {
namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path);
  if (!file)
    throw InputError(
        {Diagnostic{path.string(), 0, 0, std::string("cannot be read: ") + std::strerror(errno)}});
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The table `set` beside a Table that reads the rest: its keys are those of a scene, judged when it is laid
/// over one.
Override read_set(Table& table, const Node& node, const std::string& key, const std::string& file) {
  table.table(key);
  for (const Node& item : node.items)
    if (item.key == key && item.kind == Node::Kind::table) return {item, file};
  return {{}, file};
}

void read_selection(Table& table, Selection& selection) {
  table.read("points", selection.points);
  table.read("variants", selection.variants);
}

/// Reads the entries of one kind of [[table]]: what the Table sees, and the Node with its overrides.
template <class Entry, class Read>
std::vector<Entry> read_list(Table& parent, const Node& node, const std::string& key, Read read) {
  std::vector<Entry> entries;
  std::vector<Table> tables = parent.tables(key);
  for (const Node& list : node.items) {
    if (list.key != key) continue;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      read(tables[i], list.items[i], entries.emplace_back());
      tables[i].finish();
    }
  }
  return entries;
}

void read_check(Table& table, const Node& node, CheckUse& use) {
  table.require("check", use.check, "a name out of 'list checks'");
  table.read("claim", use.claim);
  table.read("systematic", use.settings.systematic);
  table.read("resolution", use.settings.resolution);
  table.read("reason", use.settings.reason);
  read_selection(table, use.where);
  if (std::optional<Table> numbers = table.table("numbers"))
    for (const Node& item : node.items)
      if (item.key == "numbers")
        for (const Node& entry : item.items) numbers->read(entry.key, use.settings.numbers[entry.key]);
  use.limits =
      read_list<KnownLimit>(table, node, "known-limit", [](Table& inner, const Node&, KnownLimit& limit) {
        inner.require("reason", limit.reason, "what the source says");
        read_selection(inner, limit.where);
      });
}

void read_tier(Table& table, const Node& node, const std::string& file, Tier& tier) {
  table.require("name", tier.name, list_words(tier_names()));
  table.read("sweeps", tier.sweeps);
  read_selection(table, tier.where);
  tier.changes =
      read_list<TierChange>(table, node, "change", [&](Table& inner, const Node& entry, TierChange& change) {
        read_selection(inner, change.where);
        change.set = read_set(inner, entry, "set", file);
      });
}

void read_sweep(Table& table, const Node& node, const std::string& file, Sweep& sweep) {
  table.require("knob", sweep.knob, "a short name, for example 'time-step'");
  table.require("label", sweep.label, "the axis label with units");
  table.require("variant", sweep.variant, "a variant of the case");
  table.require("point", sweep.point, "a point of the case");
  table.require("check", sweep.use.check, "the check whose value is followed");
  table.require("quantity", sweep.quantity, "what the check's value is");
  table.require("reference-source", sweep.reference_source, "what the reference run is");
  table.read("expected-order", sweep.expected_order);
  sweep.reference = read_set(table, node, "reference", file);
  sweep.points =
      read_list<SweepPoint>(table, node, "at", [&](Table& inner, const Node& entry, SweepPoint& point) {
        inner.require("knob", point.knob, "the value on the axis");
        point.set = read_set(inner, entry, "set", file);
      });
}

void read_mutant(Table& table, const Node& node, const std::string& file, Mutant& mutant) {
  table.require("mutation", mutant.mutation, "the name of a planted fault");
  table.require("check", mutant.check, "the check of this case that must fail");
  table.require("variant", mutant.variant, "a variant of the case");
  table.require("point", mutant.point, "a point of the case");
  mutant.set = read_set(table, node, "set", file);
}

void read_head(Table& root, Case& result) {
  root.require("name", result.name, "the name of the folder");
  root.require("topic", result.topic, "the name of the folder above");
  root.require("summary", result.summary, "one sentence");
  root.require("question", result.question, "what the case asks, one or two sentences");
  root.read("claims", result.claims);
}

void read_lists(Table& root, const Node& document, const std::string& file, Case& result) {
  result.equations =
      read_list<Equation>(root, document, "equation", [](Table& table, const Node&, Equation& equation) {
        table.require("tex", equation.tex, "the equation in TeX");
        table.require("text", equation.text, "the equation in plain characters");
        table.require("citation", equation.citation, "author, year, place");
      });
  result.points =
      read_list<Point>(root, document, "point", [&](Table& table, const Node& node, Point& point) {
        table.require("name", point.name, "a short name");
        table.read("summary", point.summary);
        table.read("variants", point.variants);
        point.set = read_set(table, node, "set", file);
      });
  result.variants =
      read_list<Variant>(root, document, "variant", [&](Table& table, const Node& node, Variant& variant) {
        table.require("name", variant.name, "a short name");
        table.read("summary", variant.summary);
        table.read("points", variant.points);
        variant.set = read_set(table, node, "set", file);
      });
  result.checks = read_list<CheckUse>(root, document, "check", read_check);
  const auto with_file = [&file](auto read) {
    return [&file, read](Table& table, const Node& node, auto& entry) { read(table, node, file, entry); };
  };
  result.tiers = read_list<Tier>(root, document, "tier", with_file(read_tier));
  result.sweeps = read_list<Sweep>(root, document, "sweep", with_file(read_sweep));
  result.mutants = read_list<Mutant>(root, document, "mutant", with_file(read_mutant));
}
}  // namespace

Case read_case(const std::string& folder) {
  Case result;
  result.folder = folder;
  const std::string file = (fs::path(folder) / "case.toml").string();
  result.scene_file = (fs::path(folder) / "scene.toml").string();
  const Node document = parse_document(read_text(file), file);
  result.scene = parse_document(read_text(result.scene_file), result.scene_file);
  result.readme = read_text(fs::path(folder) / "README.md");
  Diagnostics diagnostics(file, document);
  Table root(document, "", diagnostics);
  read_head(root, result);
  read_lists(root, document, file, result);
  root.finish();
  check_case_rules(result, diagnostics);
  diagnostics.raise();
  return result;
}

std::vector<Case> read_cases(const std::string& folder) {
  if (!fs::is_directory(folder))
    throw InputError({Diagnostic{folder, 0, 0, "no such folder: give the one that holds the cases"}});
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "case.toml") folders.push_back(entry.path().parent_path());
  std::sort(folders.begin(), folders.end());
  std::vector<Case> cases;
  for (const fs::path& path : folders) cases.push_back(read_case(path.string()));
  return cases;
}

}  // namespace sandglass
