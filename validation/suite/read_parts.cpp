#include "validation/suite/read_parts.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace sandglass {

void report_idle(const std::vector<std::string>& patterns, const std::string& kind,
                 const std::vector<Choice>& choices, const std::string& path, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < patterns.size(); ++i)
    if (std::ranges::none_of(choices, [&](const Choice& choice) { return speaks_of(patterns[i], choice); }))
      diagnostics.report(item_path(path, i), unknown_word(kind, wanted_part(patterns[i]), words_of(choices)));
}

std::vector<std::string> read_choice(Table& table, const std::string& key, const std::string& kind,
                                     const std::vector<Choice>& choices, Diagnostics& diagnostics) {
  const std::vector<std::string> patterns = read_words(table, key);
  report_idle(patterns, kind, choices, table.path_of(key), diagnostics);
  if (patterns.empty()) return {};
  std::vector<std::string> names = choose(patterns, choices);
  if (names.empty() && table.clean(key))
    diagnostics.report(table.path_of(key), shown(table.path_of(key)) + " takes away every " + kind);
  return names;
}

std::vector<std::string> Choices::read_points(Table& table) const {
  return read_choice(table, "points", "point", points, *diagnostics);
}

std::vector<std::string> Choices::read_variants(Table& table) const {
  return read_choice(table, "variants", "variant", variants, *diagnostics);
}

void Choices::read(Table& table, Selection& where) const {
  where.points = read_points(table);
  where.variants = read_variants(table);
}

std::vector<Choice> choices_of(const Node& document, const std::string& key) {
  std::vector<Choice> choices;
  const Node* list = entry_of(document, key);
  if (!list) return choices;
  for (const Node& table : list->items) {
    const Node* name = entry_of(table, "name");
    if (!name || name->kind != Node::Kind::text) continue;
    Choice& choice = choices.emplace_back(Choice{name->text, {}});
    if (const Node* tags = entry_of(table, "tags")) {
      if (tags->kind == Node::Kind::text) choice.tags.push_back(tags->text);
      for (const Node& tag : tags->items) choice.tags.push_back(tag.text);
    }
  }
  return choices;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  if (!file)
    throw InputError({Diagnostic{path, 0, 0, std::string("cannot be read: ") + std::strerror(errno)}});
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> read_words(Table& table, const std::string& key) {
  std::vector<std::string> words;
  if (table.is(key, Node::Kind::text))
    table.read(key, words.emplace_back());
  else
    table.read(key, words);
  return words;
}

Override read_set(Table& table, const Node& node, const std::string& key, const std::string& file) {
  table.table(key);
  const Node* found = entry_of(node, key);
  if (found && found->kind == Node::Kind::table) return {*found, file, {}};
  return {{}, file, {}};
}

const Node* entry_of(const Node& table, const std::string& key) {
  const auto found = std::ranges::find(table.items, key, &Node::key);
  return found == table.items.end() ? nullptr : &*found;
}

void read_numbers(Table& table, const Node& node, const std::string& key,
                  const std::vector<std::string>& checks, Diagnostics& diagnostics, law::Arguments& numbers) {
  std::optional<Table> given = table.table(key);
  if (!given) return;
  for (const Node& entry : entry_of(node, key)->items) {
    given->read(entry.key, numbers[entry.key]);
    for (const CheckInfo& check : all_checks())
      if (chosen(checks, {check.name, {}}))
        report_idle({entry.key}, "number", choices_of(check.parameters), given->path_of(entry.key),
                    diagnostics);
  }
}

}  // namespace sandglass
