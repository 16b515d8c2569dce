#include "validation/suite/scene_keys.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/write_node.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace sandglass {

namespace {
bool is_table_list(const Node& node) {
  return node.kind == Node::Kind::list && !node.items.empty() && node.items.front().kind == Node::Kind::table;
}

/// Calls `visit(table, entry)` for each value that is no table; it may change both.
void visit_values(Node& table, const std::string& prefix,
                  const std::function<void(const std::string&, Node&)>& visit) {
  for (Node& item : table.items) {
    const std::string path = prefix + item.key;
    if (item.kind == Node::Kind::table)
      visit_values(item, path + ".", visit);
    else if (is_table_list(item))
      for (Node& entry : item.items) visit_values(entry, path + ".", visit);
    else
      visit(path, item);
  }
}

void remove_values(Node& table, const std::string& prefix, const std::string& key) {
  std::erase_if(table.items, [&](const Node& item) { return prefix + item.key == key; });
  for (Node& item : table.items) {
    const std::string path = prefix + item.key + ".";
    if (item.kind == Node::Kind::table) remove_values(item, path, key);
    if (is_table_list(item))
      for (Node& entry : item.items) remove_values(entry, path, key);
  }
}

Node tree_of(const Scene& scene) { return parse_document(write_scene(scene), "scene"); }

/// Null where a scene cannot be so.
std::optional<Scene> read(const Node& tree) {
  try {
    return read_scene_text(compose_text(with_origin(tree, "scene")).text, "scene");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Null where the scene needs the key.
std::optional<Scene> without(const Scene& scene, const std::string& key) {
  Node tree = tree_of(scene);
  remove_values(tree, "", key);
  return read(tree);
}

/// Whole numbers change by one at least.
void scale(Node& node, double factor) {
  if (node.kind == Node::Kind::number) node.number *= factor;
  if (node.kind == Node::Kind::whole) {
    const double change = node.whole * (factor - 1);
    node.whole += static_cast<std::int64_t>(std::copysign(std::ceil(std::abs(change)), change));
  }
  if (node.kind == Node::Kind::list)
    for (Node& item : node.items) scale(item, factor);
}

std::optional<Miswired> scaled_by(const Scene& scene, const std::string& key, double factor,
                                  const char* how) {
  Node tree = tree_of(scene);
  visit_values(tree, "", [&](const std::string& path, Node& value) {
    if (path == key) scale(value, factor);
  });
  std::optional<Scene> changed = read(tree);
  if (!changed || write_scene(*changed) == write_scene(scene)) return std::nullopt;
  return Miswired{how, std::move(*changed)};
}
}  // namespace

bool reaches_method(const std::string& key) {
  for (const char* section : {"title", "run.", "observe.", "output."})
    if (key.starts_with(section)) return false;
  return !key.ends_with(".name");
}

std::vector<std::string> method_keys(const Scene& scene) {
  std::set<std::string> keys;
  Node tree = tree_of(scene);
  visit_values(tree, "", [&](const std::string& path, Node&) {
    if (reaches_method(path)) keys.insert(path);
  });
  return {keys.begin(), keys.end()};
}

std::optional<Miswired> scaled_key(const Scene& scene, const std::string& key) {
  std::optional<Miswired> larger = scaled_by(scene, key, 1.05, "5% more");
  return larger ? std::move(larger) : scaled_by(scene, key, 0.95, "5% less");
}

std::optional<Miswired> dropped_key(const Scene& scene, const std::string& key) {
  std::optional<Scene> changed = without(scene, key);
  if (!changed || write_scene(*changed) == write_scene(scene)) return std::nullopt;
  return Miswired{"left out", std::move(*changed)};
}

bool is_default(const Scene& scene, const std::string& key) {
  const std::optional<Scene> changed = without(scene, key);
  return changed && write_scene(*changed) == write_scene(scene);
}

}  // namespace sandglass
