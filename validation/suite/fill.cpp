#include "validation/suite/fill.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Calls `visit` with each name in braces, where its brace opens and what comes after the other.
template <class Visit>
void for_each_name(const std::string& text, Visit visit) {
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) return;
    visit(text.substr(open + 1, close - open - 1), open, close + 1);
  }
}

std::string text_of(const Node& value) {
  switch (value.kind) {
    case Node::Kind::whole:
      return fmt::format("{}", value.whole);
    case Node::Kind::number:
      return fmt::format("{}", value.number);
    case Node::Kind::flag:
      return value.flag ? "true" : "false";
    default:
      return value.text;
  }
}

/// The value in the place of the text.
Node in_place_of(const Node& text, Node value) {
  value.key = text.key;
  value.place = text.place;
  value.key_place = text.key_place;
  return value;
}

Node filled_text(const Node& node, const ValueOf& value_of) {
  Node result = node;
  result.text.clear();
  const Node* whole = nullptr;
  std::size_t done = 0;
  for_each_name(node.text, [&](const std::string& name, std::size_t begin, std::size_t end) {
    const Node* value = value_of(name, node);
    if (!value) return;
    if (begin == 0 && end == node.text.size()) whole = value;
    result.text += node.text.substr(done, begin - done) + text_of(*value);
    done = end;
  });
  result.text += node.text.substr(done);
  return whole ? in_place_of(node, *whole) : result;
}
}  // namespace

std::vector<std::string> names_in_braces(const std::string& text) {
  std::vector<std::string> names;
  for_each_name(text, [&](const std::string& name, std::size_t, std::size_t) { names.push_back(name); });
  return names;
}

Node filled(const Node& node, const ValueOf& value_of) {
  if (node.kind == Node::Kind::text) return filled_text(node, value_of);
  Node result = node;
  for (Node& item : result.items) item = filled(item, value_of);
  return result;
}

}  // namespace sandglass
