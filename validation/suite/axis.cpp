#include "validation/suite/axis.hpp"

#include "sim/base/spelling.hpp"
#include "validation/suite/fill.hpp"
#include "validation/suite/pattern.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Columns of equal length: row i holds one value of each.
struct Axis {
  std::vector<Node> columns;
  std::size_t rows() const { return columns.front().items.size(); }
};

/// Which axis a column belongs to, and which of its columns it is.
struct ColumnPlace {
  std::size_t axis, column;
};

/// The row taken of each axis.
using Rows = std::map<std::size_t, std::size_t>;

const Node* entry(const Node& table, const std::string& key) {
  const auto found = std::ranges::find(table.items, key, &Node::key);
  return found == table.items.end() ? nullptr : &*found;
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
  void multiply(const Node& point, std::vector<Node>& points) {
    const Node* except = entry(point, "except");
    bool left_out = false;
    for (const Rows& rows : combinations(point)) {
      Node made = filled(
          point, [&](const std::string& column, const Node& user) { return value(column, rows, user); });
      std::erase_if(made.items, [](const Node& item) { return item.key == "except"; });
      const Node* name = entry(made, "name");
      if (except && name && excludes(*except, *name))
        left_out = true;
      else
        points.push_back(std::move(made));
    }
    if (except && !left_out) report(*except, "'except' matches the name of no point");
  }

 private:
  /// Once: every combination of a template makes the same mistake.
  void report(const Node& node, const std::string& message) {
    if (reported_.insert({node.place, message}).second) diagnostics_.report_at(node.place, "axis", message);
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

  /// Rows of the axes that the name holds, the last one fastest.
  std::vector<Rows> combinations(const Node& point) const {
    std::vector<Rows> all(1);
    const Node* name = entry(point, "name");
    if (!name) return all;
    for (const std::string& column : names_in_braces(name->text)) {
      const auto found = places_.find(column);
      if (found == places_.end() || all.front().contains(found->second.axis)) continue;
      std::vector<Rows> more;
      for (const Rows& rows : all)
        for (std::size_t row = 0; row < axes_[found->second.axis].rows(); ++row)
          more.emplace_back(rows)[found->second.axis] = row;
      all = std::move(more);
    }
    return all;
  }

  /// The value of a column in the chosen rows; null, after a report at `user`, when there is none.
  const Node* value(const std::string& column, const Rows& rows, const Node& user) {
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

  /// 'except' names the combinations that a product does not make: one pattern, or a list.
  static bool excludes(const Node& except, const Node& name) {
    const auto fits = [&](const Node& pattern) { return matches(pattern.text, name.text); };
    return except.kind == Node::Kind::text ? fits(except) : std::ranges::any_of(except.items, fits);
  }

  Diagnostics& diagnostics_;
  std::vector<Axis> axes_;
  std::map<std::string, ColumnPlace> places_;
  std::set<std::pair<Place, std::string>> reported_;
};
}  // namespace

Node multiply_points(const Node& document, Diagnostics& diagnostics) {
  Axes axes(document, diagnostics);
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
