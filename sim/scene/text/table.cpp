#include "sim/scene/text/table.hpp"

#include "sim/base/spelling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::string kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::text:
      return "a text";
    case Node::Kind::whole:
      return "a whole number";
    case Node::Kind::number:
      return "a number with a point or exponent";
    case Node::Kind::flag:
      return "true or false";
    case Node::Kind::date:
      return "a date or time";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::table:
      return "a table";
  }
  return "";
}
}  // namespace

Table::Table(const Node& node, std::string path, Diagnostics& diagnostics)
    : node_(&node), path_(std::move(path)), diagnostics_(&diagnostics) {}

const Node* Table::entry(const std::string& key) const {
  const auto match = [&key](const Node& item) { return item.key == key; };
  const auto found = std::find_if(node_->items.begin(), node_->items.end(), match);
  return found == node_->items.end() ? nullptr : &*found;
}

const Node* Table::take(const std::string& key) {
  asked_.push_back(key);
  return entry(key);
}

bool Table::says(const std::string& key, const std::string& text) const {
  const Node* node = entry(key);
  return node && node->kind == Node::Kind::text && node->text == text;
}

bool Table::is(const std::string& key, Node::Kind kind) const {
  const Node* node = entry(key);
  return node && node->kind == kind;
}

std::optional<Table> Table::table(const std::string& key) {
  const Node* node = take(key);
  if (!node) return std::nullopt;
  if (node->kind == Node::Kind::table) return Table(*node, path_of(key), *diagnostics_);
  report_type(*node, path_of(key), "a table");
  return std::nullopt;
}

std::vector<Table> Table::tables(const std::string& key) {
  const Node* node = take(key);
  std::vector<Table> list;
  if (!node) return list;
  const auto is_table = [](const Node& item) { return item.kind == Node::Kind::table; };
  if (node->kind != Node::Kind::list || !std::all_of(node->items.begin(), node->items.end(), is_table)) {
    report_type(*node, path_of(key), fmt::format("a list of tables, each headed [[{}]]", path_of(key)));
    return list;
  }
  for (std::size_t i = 0; i < node->items.size(); ++i)
    list.emplace_back(node->items[i], item_path(path_of(key), i), *diagnostics_);
  return list;
}

void Table::refuse(const std::string& key, const std::string& reason) {
  skip(key);
  if (const Node* node = entry(key))
    diagnostics_->report_at(node->key_place, path_of(key), shown(path_of(key)) + ' ' + reason);
}

void Table::report_missing(const std::string& key, const std::string& remedy) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  diagnostics_->report(path_of(key), fmt::format("missing {}: {}", shown(path_of(key)), remedy));
}

void Table::finish() {
  const auto listed = [](const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const Node& item : node_->items) {
    if (listed(asked_, item.key) || listed(skipped_, item.key)) continue;
    const std::string path = path_of(item.key);
    std::string message = unknown_word("key", item.key, asked_);
    message.replace(message.find('\''), item.key.size() + 2, shown(path));
    diagnostics_->report_at(item.key_place, path, message);
  }
}

void Table::report_type(const Node& node, const std::string& path, const std::string& wanted) {
  diagnostics_->report(path, fmt::format("{} must be {}, not {}", shown(path), wanted, kind_name(node.kind)));
}

void Table::convert(const Node& node, const std::string& path, bool& target) {
  if (node.kind == Node::Kind::flag)
    target = node.flag;
  else
    report_type(node, path, "true or false");
}

void Table::convert(const Node& node, const std::string& path, double& target) {
  const bool whole = node.kind == Node::Kind::whole;
  if (!whole && node.kind != Node::Kind::number) return report_type(node, path, "a number");
  const double value = whole ? static_cast<double>(node.whole) : node.number;
  if (std::isfinite(value))
    target = value;
  else
    diagnostics_->report(path, fmt::format("{} is {}; it must be a finite number", shown(path), value));
}

void Table::convert(const Node& node, const std::string& path, int& target) {
  std::uint64_t whole = 0;
  convert(node, path, whole);
  constexpr std::uint64_t largest = std::numeric_limits<int>::max();
  if (whole <= largest)
    target = diagnostics_->clean(path) ? static_cast<int>(whole) : target;
  else
    diagnostics_->report(path, fmt::format("{} is {}; at most {} is allowed", shown(path), whole, largest));
}

void Table::convert(const Node& node, const std::string& path, std::uint64_t& target) {
  if (node.kind != Node::Kind::whole)
    return report_type(node, path, "a whole number without point or exponent, like 1000");
  if (node.whole >= 0)
    target = static_cast<std::uint64_t>(node.whole);
  else
    diagnostics_->report(path, fmt::format("{} is {}; it must not be negative", shown(path), node.whole));
}

void Table::convert(const Node& node, const std::string& path, std::string& target) {
  if (node.kind == Node::Kind::text)
    target = node.text;
  else
    report_type(node, path, "a text in quotes");
}

void Table::convert(const Node& node, const std::string& path, std::array<double, 2>& target) {
  std::vector<double> values;
  if (node.kind != Node::Kind::list || node.items.size() != 2)
    return report_type(node, path, "a list of two numbers, [low, high]");
  convert(node, path, values);
  if (diagnostics_->clean(path)) target = {values[0], values[1]};
}

}  // namespace sandglass
