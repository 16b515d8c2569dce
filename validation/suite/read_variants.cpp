#include "validation/suite/read_parts.hpp"

#include <algorithm>
#include <filesystem>

namespace sandglass {

namespace {
std::vector<Choice> choices_among(const std::vector<SharedVariant>& variants) {
  std::vector<Choice> choices;
  for (const SharedVariant& shared : variants) choices.push_back({shared.variant.name, shared.variant.tags});
  return choices;
}

std::vector<std::string> read_check_patterns(Table& table, Diagnostics& diagnostics) {
  const std::vector<std::string> patterns = read_words(table, "checks");
  if (!table.has("checks")) table.report_missing("checks", "names or patterns of checks");
  report_idle(patterns, "check", choices_of(all_checks()), table.path_of("checks"), diagnostics);
  return patterns;
}

void read_names(Table& table, Variant& variant) {
  table.require("name", variant.name, "a short name");
  table.read("summary", variant.summary);
  variant.tags = read_words(table, "tags");
}

void read_shared(Table& table, const Node& node, const std::string& file, Diagnostics& diagnostics,
                 SharedVariant& shared) {
  read_names(table, shared.variant);
  shared.variant.sets.push_back(read_set(table, node, "set", file));
  read_each(table, node, "add", [&](Table& inner, const Node& entry) {
    SharedVariant::Addition& addition = shared.additions.emplace_back();
    addition.checks = read_check_patterns(inner, diagnostics);
    inner.tables("observe");
    if (const Node* list = entry_of(entry, "observe")) addition.observers = {*list, file};
  });
}

void read_limit(Table& table, const Node& node, const std::vector<Choice>& variants, Diagnostics& diagnostics,
                SharedLimit& limit) {
  limit.checks = read_check_patterns(table, diagnostics);
  limit.variants = read_words(table, "variants");
  limit.points = read_words(table, "points");
  table.require("reason", limit.reason, "what the source says");
  read_numbers(table, node, "instead", limit.checks, diagnostics, limit.instead);
  report_idle(limit.variants, "variant", variants, table.path_of("variants"), diagnostics);
}
}  // namespace

VariantLibrary read_variant_library(const std::string& file) {
  VariantLibrary library;
  if (!std::filesystem::exists(file)) return library;
  const Node document = parse_document(read_text(file), file);
  Diagnostics diagnostics(file, document);
  Table root(document, "", diagnostics);
  read_each(root, document, "variant", [&](Table& table, const Node& node) {
    read_shared(table, node, file, diagnostics, library.variants.emplace_back());
  });
  const std::vector<Choice> variants = choices_among(library.variants);
  read_each(root, document, "known-limit", [&](Table& table, const Node& node) {
    read_limit(table, node, variants, diagnostics, library.limits.emplace_back());
  });
  root.finish();
  diagnostics.raise();
  return library;
}

std::vector<SharedVariant> read_variants(Table& root, const Node& document, const VariantLibrary& library,
                                         Diagnostics& diagnostics) {
  const std::vector<std::string> patterns = read_words(root, "variants"), needs = read_words(root, "needs");
  const std::vector<Choice> choices = choices_among(library.variants);
  report_idle(patterns, "variant", choices, "variants", diagnostics);
  report_idle(needs, "tag of a variant", choices, "needs", diagnostics);
  std::vector<SharedVariant> variants;
  const auto able = [&](const Choice& choice) {
    return std::ranges::all_of(needs, [&](const std::string& tag) { return speaks_of(tag, choice); });
  };
  if (root.has("variants") || root.has("needs"))
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (able(choices[i]) && chosen(patterns, choices[i])) variants.push_back(library.variants[i]);
  for (const Choice& own : choices_of(document, "variant")) {
    SharedVariant& local = variants.emplace_back();
    local.variant.name = own.name;
    local.variant.tags = own.tags;
  }
  return variants;
}

void read_own_variants(Table& root, const Node& document, const std::string& file, const Choices& choices,
                       Case& result) {
  std::size_t own = result.variants.size() - choices_of(document, "variant").size();
  read_each(root, document, "variant", [&](Table& table, const Node& node) {
    std::vector<std::string> names;
    Variant read;
    if (table.has("name")) {
      read_names(table, read);
      names = {own < result.variants.size() ? result.variants[own++].name : ""};
    } else {
      names = choices.read_variants(table);
      if (!table.has("variants"))
        table.report_missing("variants",
                             "which variants this changes; a variant of this case alone has a 'name'");
    }
    const std::vector<std::string> points = choices.read_points(table);
    const Override set = read_set(table, node, "set", file);
    for (Variant& variant : result.variants) {
      if (std::ranges::find(names, variant.name) == names.end()) continue;
      if (!read.summary.empty()) variant.summary = read.summary;
      if (!points.empty()) variant.points = points;
      variant.sets.push_back(set);
    }
  });
}

}  // namespace sandglass
