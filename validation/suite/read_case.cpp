#include "sim/base/error.hpp"
#include "validation/suite/axis.hpp"
#include "validation/suite/read_parts.hpp"

#include <algorithm>
#include <filesystem>

namespace sandglass {

namespace {
namespace fs = std::filesystem;

void read_head(Table& root, Case& result) {
  root.require("name", result.name, "the name of the folder");
  root.require("topic", result.topic, "the name of the folder above");
  root.require("summary", result.summary, "one sentence");
  root.require("question", result.question, "what the case asks, one or two sentences");
  root.read("claims", result.claims);
}

void read_equations(Table& root, const Node& document, Case& result) {
  read_each(root, document, "equation", [&](Table& table, const Node&) {
    Equation& equation = result.equations.emplace_back();
    table.require("tex", equation.tex, "the equation in TeX");
    table.require("text", equation.text, "the equation in plain characters");
    table.require("citation", equation.citation, "author, year, place");
  });
}

void read_points(Table& root, const Node& document, const std::string& file, const Choices& choices,
                 Case& result) {
  read_each(root, document, "point", [&](Table& table, const Node& node) {
    Point& point = result.points.emplace_back();
    table.require("name", point.name, "a short name");
    table.read("summary", point.summary);
    point.tags = read_words(table, "tags");
    point.variants = choices.read_variants(table);
    point.set = read_set(table, node, "set", file);
  });
}

/// What a variant observes for the checks that the case makes of it.
void add_observers(const std::vector<SharedVariant>& variants, Case& result) {
  const auto makes = [&](const Variant& variant, const std::vector<std::string>& checks) {
    return std::ranges::any_of(result.checks, [&](const CheckUse& use) {
      return chosen(checks, {use.check, {}}) && std::ranges::any_of(result.points, [&](const Point& point) {
               return result.use_of(use.check, point.name, variant.name) != nullptr;
             });
    });
  };
  for (std::size_t i = 0; i < variants.size(); ++i)
    for (const SharedVariant::Addition& addition : variants[i].additions)
      if (makes(result.variants[i], addition.checks)) result.variants[i].added.push_back(addition.observers);
}

void require_some(bool some, const std::string& key, Diagnostics& diagnostics) {
  if (!some) diagnostics.report(key, "a case needs at least one [[" + key + "]]");
}

void require_unique(const std::vector<Choice>& entries, const std::string& key, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t before = 0; before < i; ++before)
      if (entries[i].name == entries[before].name)
        diagnostics.report(item_path(key, i) + ".name",
                           "the name '" + entries[i].name + "' is given twice; keep one");
}

/// A pattern finds a name or a tag, so that no word may be both.
void require_distinct(const std::vector<Choice>& points, Diagnostics& diagnostics) {
  for (const Choice& point : points)
    for (const std::string& tag : point.tags)
      if (std::ranges::find(points, tag, &Choice::name) != points.end())
        diagnostics.report("point", "'" + tag + "' is the name of a point and a tag: rename one");
}

void read_all(Table& root, const Node& document, const std::string& file, const VariantLibrary& library,
              Diagnostics& diagnostics, Case& result) {
  read_head(root, result);
  read_equations(root, document, result);
  const std::vector<std::string> tags = read_words(root, "tags");
  const std::vector<SharedVariant> variants = read_variants(root, document, library, diagnostics);
  Choices choices{choices_of(document, "point"), {}, &diagnostics};
  for (Choice& point : choices.points) point.tags.insert(point.tags.end(), tags.begin(), tags.end());
  for (const SharedVariant& shared : variants) {
    result.variants.push_back(shared.variant);
    choices.variants.push_back({shared.variant.name, shared.variant.tags});
  }
  require_some(!choices.points.empty(), "point", diagnostics);
  require_some(!choices.variants.empty(), "variant", diagnostics);
  require_unique(choices.points, "point", diagnostics);
  require_unique(choices.variants, "variant", diagnostics);
  require_distinct(choices.points, diagnostics);
  read_points(root, document, file, choices, result);
  read_own_variants(root, document, file, choices, result);
  diagnostics.raise();
  read_checks(root, document, library, choices, result);
  require_some(!result.checks.empty(), "check", diagnostics);
  add_observers(variants, result);
  read_tiers(root, document, file, choices, result);
  require_unique(choices_of(document, "tier"), "tier", diagnostics);
  read_sweeps(root, document, file, choices, result);
  read_mutants(root, document, file, choices, result);
  root.finish();
  diagnostics.raise();
}
}  // namespace

Case read_case(const std::string& folder) {
  Case result;
  result.folder = folder;
  const std::string file = (fs::path(folder) / "case.toml").string();
  result.scene_file = (fs::path(folder) / "scene.toml").string();
  const Node text = parse_document(read_text(file), file);
  result.scene = parse_document(read_text(result.scene_file), result.scene_file);
  result.readme = read_text((fs::path(folder) / "README.md").string());
  const fs::path shared = fs::path(folder).parent_path().parent_path() / "variants.toml";
  const VariantLibrary library = read_variant_library(shared.string());
  Diagnostics templates(file, text);
  const Node document = multiply_points(text, templates);
  templates.raise();
  Diagnostics diagnostics(file, document);
  Table root(document, "", diagnostics);
  read_all(root, document, file, library, diagnostics, result);
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
