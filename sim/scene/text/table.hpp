#pragma once

#include "sim/base/spelling.hpp"
#include "sim/scene/text/diagnostics.hpp"
#include "sim/scene/text/document.hpp"
#include "sim/scene/text/words.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// Reads the entries of one TOML table into plain values and reports every error of type or spelling.
/// The keys that were asked for are the allowed ones; finish() reports all others.
class Table {
 public:
  Table(const Node& node, std::string path, Diagnostics& diagnostics);

  bool has(const std::string& key) const { return entry(key) != nullptr; }
  bool is(const std::string& key, Node::Kind kind) const;
  /// The key is there, with this text.
  bool says(const std::string& key, const std::string& text) const;
  std::string path_of(const std::string& key) const { return join_path(path_, key); }
  /// No error so far in the value under the key, or anywhere in the table.
  bool clean(const std::string& key) const { return diagnostics_->clean(path_of(key)); }
  bool clean() const { return diagnostics_->clean(path_); }

  /// Fills in `target` when the key is there and right; leaves it when the key is absent; reports otherwise.
  template <class Value>
  void read(const std::string& key, Value& target) {
    if (const Node* node = take(key)) convert(*node, path_of(key), target);
  }
  /// As read(), and reports an absent key.
  template <class Value>
  void require(const std::string& key, Value& target, const std::string& remedy) {
    read(key, target);
    if (!has(key)) report_missing(key, remedy);
  }
  /// A word out of a list; `kind` says in messages what it names.
  template <class Value>
  void read_word(const std::string& key, const std::string& kind, Value& target, const Words<Value>& words) {
    if (const Node* node = take(key)) convert_word(*node, path_of(key), kind, target, words);
  }
  /// One word for both entries of a pair, or a list of two words.
  template <class Value>
  void read_pair(const std::string& key, const std::string& kind, std::array<Value, 2>& target,
                 const Words<Value>& words);

  /// The table under the key; nothing when it is absent or, after a report, of another type.
  std::optional<Table> table(const std::string& key);
  /// The tables of [[key]].
  std::vector<Table> tables(const std::string& key);

  /// Reports the key, when it is there, with the reason why it cannot be used here.
  void refuse(const std::string& key, const std::string& reason);
  /// Lets the key pass unread, where an error reported already leaves no way to judge it.
  void skip(const std::string& key) { skipped_.push_back(key); }
  void report_missing(const std::string& key, const std::string& remedy);
  /// Reports every key that was not asked for, with the nearest one that was.
  void finish();

 private:
  const Node* entry(const std::string& key) const;
  const Node* take(const std::string& key);
  void report_type(const Node& node, const std::string& path, const std::string& wanted);

  void convert(const Node& node, const std::string& path, bool& target);
  void convert(const Node& node, const std::string& path, double& target);
  void convert(const Node& node, const std::string& path, int& target);
  void convert(const Node& node, const std::string& path, std::uint64_t& target);
  void convert(const Node& node, const std::string& path, std::string& target);
  template <class Value>
  void convert(const Node& node, const std::string& path, std::optional<Value>& target);
  template <class Value>
  void convert(const Node& node, const std::string& path, std::vector<Value>& target);
  void convert(const Node& node, const std::string& path, std::array<double, 2>& target);
  template <class Value>
  void convert_word(const Node& node, const std::string& path, const std::string& kind, Value& target,
                    const Words<Value>& words);

  const Node* node_;
  std::string path_;
  Diagnostics* diagnostics_;
  std::vector<std::string> asked_;
  std::vector<std::string> skipped_;
};

template <class Value>
void Table::convert(const Node& node, const std::string& path, std::optional<Value>& target) {
  Value value{};
  convert(node, path, value);
  if (diagnostics_->clean(path)) target = value;
}

template <class Value>
void Table::convert(const Node& node, const std::string& path, std::vector<Value>& target) {
  if (node.kind != Node::Kind::list) return report_type(node, path, "a list of numbers, like [1, 2]");
  std::vector<Value> values(node.items.size());
  for (std::size_t i = 0; i < values.size(); ++i) convert(node.items[i], item_path(path, i), values[i]);
  if (diagnostics_->clean(path)) target = std::move(values);
}

template <class Value>
void Table::convert_word(const Node& node, const std::string& path, const std::string& kind, Value& target,
                         const Words<Value>& words) {
  if (node.kind != Node::Kind::text) return report_type(node, path, "one of " + list_words(names_of(words)));
  const auto match = [&node](const auto& candidate) { return candidate.first == node.text; };
  const auto found = std::find_if(words.begin(), words.end(), match);
  if (found != words.end())
    target = found->second;
  else
    diagnostics_->report(path, unknown_word(kind, node.text, names_of(words)));
}

template <class Value>
void Table::read_pair(const std::string& key, const std::string& kind, std::array<Value, 2>& target,
                      const Words<Value>& words) {
  const Node* node = take(key);
  if (!node) return;
  const std::string path = path_of(key);
  if (node->kind != Node::Kind::list) {
    convert_word(*node, path, kind, target[0], words);
    target[1] = target[0];
  } else if (node->items.size() != 2) {
    report_type(*node, path, "one word for both sides or a list of two words");
  } else {
    for (std::size_t i = 0; i < 2; ++i)
      convert_word(node->items[i], item_path(path, i), kind, target[i], words);
  }
}

}  // namespace sandglass
