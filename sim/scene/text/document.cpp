#include "sim/scene/text/document.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <string_view>

#include <toml++/toml.h>

namespace sandglass {

namespace {
Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

constexpr int most_parts = 64;

/// The end of the string or comment that begins here; here when none does. A string of one line ends with it.
std::size_t end_of_quoted(const std::string& text, std::size_t begin) {
  const char first = text[begin];
  if (first == '#') return std::min(text.find('\n', begin), text.size());
  if (first != '"' && first != '\'') return begin;
  const std::string triple(3, first);
  if (text.compare(begin, 3, triple) == 0) {
    const std::size_t end = text.find(triple, begin + 3);
    return end == std::string::npos ? text.size() : end + 3;
  }
  std::size_t end = begin + 1;
  while (end < text.size() && text[end] != first && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// The parser takes the stack for every part of a dotted key and ends the program where that is used up.
void require_short_keys(const std::string& text, const std::string& file_name) {
  int parts = 1;
  Place place{1, 1};
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = end_of_quoted(text, i);
    if (end == i) {
      if (std::string_view("=,{}[]\n").find(text[i]) != std::string_view::npos) parts = 1;
      if (text[i] == '.' && ++parts > most_parts)
        throw InputError({Diagnostic{file_name, place.line, place.column,
                                     "a key of more than 64 parts; no scene needs more than four"}});
    }
    for (const std::size_t next = std::max(end, i + 1); i < next; ++i)
      place = text[i] == '\n' ? Place{place.line + 1, 1} : Place{place.line, place.column + 1};
  }
}

Node convert(const toml::node& source);

std::vector<Node> convert_items(const toml::table& table) {
  std::vector<Node> items;
  for (const auto& [key, value] : table) {
    items.push_back(convert(value));
    items.back().key = std::string(key.str());
    items.back().key_place = place_of(key.source());
  }
  std::sort(items.begin(), items.end(),
            [](const Node& a, const Node& b) { return a.key_place < b.key_place; });
  return items;
}

std::vector<Node> convert_items(const toml::array& array) {
  std::vector<Node> items;
  for (const toml::node& value : array) items.push_back(convert(value));
  return items;
}

Node convert(const toml::node& source) {
  Node node;
  node.place = place_of(source.source());
  const auto fill = [&node](Node::Kind kind, auto& member, auto value) {
    node.kind = kind;
    member = std::move(value);
  };
  if (const auto* text = source.as_string())
    fill(Node::Kind::text, node.text, text->get());
  else if (const auto* whole = source.as_integer())
    fill(Node::Kind::whole, node.whole, whole->get());
  else if (const auto* number = source.as_floating_point())
    fill(Node::Kind::number, node.number, number->get());
  else if (const auto* flag = source.as_boolean())
    fill(Node::Kind::flag, node.flag, flag->get());
  else if (const auto* array = source.as_array())
    fill(Node::Kind::list, node.items, convert_items(*array));
  else if (const auto* table = source.as_table())
    fill(Node::Kind::table, node.items, convert_items(*table));
  else
    node.kind = Node::Kind::date;
  return node;
}
}  // namespace

Node parse_document(const std::string& text, const std::string& file_name) {
  require_short_keys(text, file_name);
  try {
    Node root = convert(toml::parse(text, file_name));
    root.place = {1, 1};
    return root;
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    throw InputError({Diagnostic{file_name, place.line, place.column,
                                 "not valid TOML: " + std::string(error.description())}});
  }
}

}  // namespace sandglass
