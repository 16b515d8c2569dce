#include "validation/suite/write_node.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      result += fmt::format("\\u{:04X}", static_cast<int>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string number_text(double number) {
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

bool is_table(const OriginNode& item) { return item.node.kind == Node::Kind::table; }

bool is_table_list(const OriginNode& item) {
  return item.node.kind == Node::Kind::list && !item.items.empty() &&
         std::all_of(item.items.begin(), item.items.end(), is_table);
}

std::string value_text(const OriginNode& item) {
  const Node& node = item.node;
  std::string text;
  switch (node.kind) {
    case Node::Kind::text:
      return quoted(node.text);
    case Node::Kind::whole:
      return fmt::format("{}", node.whole);
    case Node::Kind::number:
      return number_text(node.number);
    case Node::Kind::flag:
      return node.flag ? "true" : "false";
    case Node::Kind::date:
      return "1970-01-01";  // no scene takes a date: the reader refuses it with its place
    case Node::Kind::list:
      for (const OriginNode& entry : item.items) text += (text.empty() ? "" : ", ") + value_text(entry);
      return "[" + text + "]";
    case Node::Kind::table:
      for (const OriginNode& entry : item.items)
        text += (text.empty() ? "" : ", ") + quoted(entry.node.key) + " = " + value_text(entry);
      return "{" + text + "}";
  }
  return text;
}

class Writer {
 public:
  explicit Writer(ComposedText& composed) : composed_(composed) {}

  void table(const OriginNode& table, const std::string& path) {
    for (const OriginNode& item : table.items)
      if (!is_table(item) && !is_table_list(item))
        line(item, quoted(item.node.key) + " = " + value_text(item), item.node.key_place);
    for (const OriginNode& item : table.items) {
      const std::string inner = (path.empty() ? "" : path + ".") + quoted(item.node.key);
      if (is_table(item))
        headed(item, "[" + inner + "]", inner);
      else if (is_table_list(item))
        for (const OriginNode& entry : item.items) headed(entry, "[[" + inner + "]]", inner);
    }
  }

 private:
  void headed(const OriginNode& item, const std::string& header, const std::string& path) {
    line(item, header, item.node.place);
    table(item, path);
  }
  void line(const OriginNode& item, const std::string& text, Place place) {
    composed_.text += text + "\n";
    composed_.origin.push_back({item.file, place});
  }
  ComposedText& composed_;
};
}  // namespace

OriginNode* OriginNode::entry(const std::string& key) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const OriginNode& item) { return item.node.key == key; });
  return found == items.end() ? nullptr : &*found;
}

OriginNode with_origin(const Node& node, const std::string& file) {
  OriginNode result{node, file, {}};
  result.node.items.clear();
  for (const Node& item : node.items) result.items.push_back(with_origin(item, file));
  return result;
}

ComposedText compose_text(const OriginNode& root) {
  ComposedText composed;
  Writer(composed).table(root, "");
  return composed;
}

}  // namespace sandglass
