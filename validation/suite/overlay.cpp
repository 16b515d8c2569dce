#include "validation/suite/overlay.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/factors.hpp"
#include "validation/suite/write_node.hpp"

#include <algorithm>

namespace sandglass {

namespace {
bool is_table_list(const OriginNode& item) {
  return item.node.kind == Node::Kind::list && !item.items.empty() &&
         item.items.front().node.kind == Node::Kind::table;
}

bool removes(const Node& item) { return item.kind == Node::Kind::table && item.items.empty(); }

void merge(OriginNode& base, const Node& over, const std::string& file) {
  for (const Node& item : over.items) {
    OriginNode* found = base.entry(item.key);
    if (removes(item))
      std::erase_if(base.items, [&](const OriginNode& old) { return old.node.key == item.key; });
    else if (!found)
      base.items.push_back(with_origin(item, file));
    else if (item.kind == Node::Kind::table && found->node.kind == Node::Kind::table)
      merge(*found, item, file);
    else if (item.kind == Node::Kind::table && is_table_list(*found))
      merge(found->items.front(), item, file);
    else
      *found = with_origin(item, file);
  }
}

std::string what_of(OriginNode& observer) {
  const OriginNode* what = observer.entry("what");
  return what ? what->node.text : "";
}

void add_observers(OriginNode& root, const AddedObservers& added) {
  OriginNode* observers = root.entry("observe");
  if (!observers) {
    root.items.push_back(with_origin(added.list, added.file));
    return;
  }
  const OriginNode* every = observers->items.empty() ? nullptr : observers->items.back().entry("every");
  std::vector<OriginNode> fresh = with_origin(added.list, added.file).items;
  const auto present = [&](OriginNode& wanted) {
    return std::ranges::any_of(observers->items,
                               [&](OriginNode& observer) { return what_of(observer) == what_of(wanted); });
  };
  std::erase_if(fresh, present);
  for (OriginNode& observer : fresh)
    if (every && !observer.entry("every")) observer.items.push_back(*every);
  observers->items.insert(observers->items.end(), fresh.begin(), fresh.end());
}

/// Moves each error from the composed text to the file that the wrong line came from.
[[noreturn]] void place_errors(const InputError& error, const ComposedText& composed) {
  std::vector<Diagnostic> diagnostics = error.diagnostics();
  for (Diagnostic& diagnostic : diagnostics) {
    const auto line = static_cast<std::size_t>(diagnostic.line);
    if (line == 0 || line > composed.origin.size()) continue;
    const Origin& origin = composed.origin[line - 1];
    diagnostic.file = origin.file;
    diagnostic.line = origin.place.line;
    diagnostic.column = origin.place.column;
  }
  throw InputError(diagnostics);
}
}  // namespace

Scene lay_over(const Node& base, const std::string& base_file, const std::vector<const Override*>& overrides,
               const std::vector<AddedObservers>& added) {
  OriginNode root = with_origin(base, base_file);
  for (const Override* layer : overrides) {
    merge(root, layer->values, layer->file);
    multiply(root, layer->factors, layer->file);
  }
  for (const AddedObservers& list : added) add_observers(root, list);
  const ComposedText composed = compose_text(root);
  try {
    return read_scene_text(composed.text, base_file);
  } catch (const InputError& error) {
    place_errors(error, composed);
  }
}

}  // namespace sandglass
