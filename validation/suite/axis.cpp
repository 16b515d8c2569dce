#include "validation/suite/axis.hpp"

#include "sim/base/spelling.hpp"
#include "validation/suite/pattern.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Columns of equal length: row i holds one value of each.
struct Axis {
  std::vector<Node> columns;
  std::size_t rows() const { return columns.front().items.size(); }
};

/// Where a column stands: which axis, and which of its columns.
struct ColumnPlace {
  std::size_t axis, column;
};

const Node* entry(const Node& table, const std::string& key) {
  const auto found = std::ranges::find(table.items, key, &Node::key);
  return found == table.items.end() ? nullptr : &*found;
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

/// Calls `visit` with each name in braces, its first character and the one after its brace.
void for_each_name(const std::string& text,
                   const std::function<void(const std::string&, std::size_t, std::size_t)>& visit) {
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) return;
    visit(text.substr(open + 1, close - open - 1), open, close + 1);
  }
}

class Axes {
 public:
  Axes(const Node& document, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    const Node* list = entry(document, "axis");
    if (!list) return;
    if (list->kind != Node::Kind::list)
      report(*list, "'axis' must be a list of tables, each headed [[axis]]");
    for (const Node& table : list->items) add(table);
  }

  /// The points that a template stands for.
  void multiply(const Node& point, std::vector<Node>& points) const {
    const Node* name = entry(point, "name");
    std::vector<std::size_t> used;
    if (name && name->kind == Node::Kind::text)
      for_each_name(name->text, [&](const std::string& column, std::size_t, std::size_t) {
        const auto found = places_.find(column);
        if (found != places_.end() && std::ranges::find(used, found->second.axis) == used.end())
          used.push_back(found->second.axis);
      });
    const std::size_t before = points.size();
    std::map<std::size_t, std::size_t> rows;
    each_row(point, used, rows, points);
    std::size_t combinations = 1;
    for (const std::size_t axis : used) combinations *= axes_[axis].rows();
    const Node* except = entry(point, "except");
    if (except && points.size() - before == combinations)
      report(*except, "'except' matches the name of no point");
  }

 private:
  void report(const Node& node, const std::string& message) const {
    diagnostics_.report_at(node.place, "axis", message);
  }

  void add(const Node& table) {
    Axis axis;
    for (const Node& column : table.items) {
      const bool fits = column.kind == Node::Kind::list && !column.items.empty() &&
                        (axis.columns.empty() || column.items.size() == axis.rows());
      if (!fits) {
        report(column, fmt::format("'{}' must be a list of values, as long as the other columns of its axis",
                                   column.key));
        continue;
      }
      if (!places_.try_emplace(column.key, ColumnPlace{axes_.size(), axis.columns.size()}).second)
        report(column, "two axes have a column '" + column.key + "': rename one");
      axis.columns.push_back(column);
    }
    if (!axis.columns.empty()) axes_.push_back(std::move(axis));
  }

  void each_row(const Node& point, const std::vector<std::size_t>& used,
                std::map<std::size_t, std::size_t>& rows, std::vector<Node>& points) const {
    if (rows.size() == used.size()) {
      Node made = filled(point, rows);
      if (!left_out(made)) points.push_back(std::move(made));
      return;
    }
    const std::size_t axis = used[rows.size()];
    std::map<std::size_t, std::size_t> inner = rows;
    for (std::size_t row = 0; row < axes_[axis].rows(); ++row) {
      inner[axis] = row;
      each_row(point, used, inner, points);
    }
  }

  /// The value of a column in the chosen rows; nothing, after a report at `user`, when there is none.
  const Node* value(const std::string& column, const std::map<std::size_t, std::size_t>& rows,
                    const Node& user) const {
    const auto found = places_.find(column);
    if (found == places_.end()) {
      std::vector<std::string> names;
      for (const auto& [name, place] : places_) names.push_back(name);
      report(user, unknown_word("column of an axis", column, names));
      return nullptr;
    }
    const auto row = rows.find(found->second.axis);
    if (row == rows.end()) {
      report(user,
             "'{" + column + "}' has no value here: the name of the point must hold a column of its axis");
      return nullptr;
    }
    return &axes_[found->second.axis].columns[found->second.column].items[row->second];
  }

  /// 'except' names the combinations that a product does not make.
  static bool left_out(Node& point) {
    const Node* except = entry(point, "except");
    const Node* name = entry(point, "name");
    if (!except || !name) return false;
    std::vector<std::string> patterns{except->text};
    for (const Node& item : except->items) patterns.push_back(item.text);
    const bool left =
        std::ranges::any_of(patterns, [&](const std::string& one) { return matches(one, name->text); });
    std::erase_if(point.items, [](const Node& item) { return item.key == "except"; });
    return left;
  }

  Node filled(const Node& node, const std::map<std::size_t, std::size_t>& rows) const {
    if (node.kind == Node::Kind::text) return filled_text(node, rows);
    Node result = node;
    for (Node& item : result.items) item = filled(item, rows);
    return result;
  }

  Node filled_text(const Node& node, const std::map<std::size_t, std::size_t>& rows) const {
    Node result = node;
    result.text.clear();
    std::size_t done = 0;
    bool alone = false;
    for_each_name(node.text, [&](const std::string& column, std::size_t begin, std::size_t end) {
      const Node* found = value(column, rows, node);
      if (!found) return;
      alone = begin == 0 && end == node.text.size();
      if (alone)
        result = *found;
      else
        result.text += node.text.substr(done, begin - done) + text_of(*found);
      done = end;
    });
    if (!alone) result.text += node.text.substr(done);
    result.key = node.key;
    result.place = node.place;
    result.key_place = node.key_place;
    return result;
  }

  Diagnostics& diagnostics_;
  std::vector<Axis> axes_;
  std::map<std::string, ColumnPlace> places_;
};
}  // namespace

Node multiply_points(const Node& document, Diagnostics& diagnostics) {
  const Axes axes(document, diagnostics);
  Node result = document;
  std::erase_if(result.items, [](const Node& item) { return item.key == "axis"; });
  for (Node& item : result.items) {
    if (item.key != "point" || item.kind != Node::Kind::list) continue;
    std::vector<Node> points;
    for (const Node& point : item.items) axes.multiply(point, points);
    item.items = std::move(points);
  }
  return result;
}

}  // namespace sandglass
