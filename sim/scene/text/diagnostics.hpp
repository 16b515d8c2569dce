#pragma once

#include "sim/base/error.hpp"
#include "sim/scene/text/document.hpp"

#include <map>
#include <string>
#include <unordered_set>
#include <vector>

namespace sandglass {

/// Collects every error of one scene and finds its place in the text.
/// A path names a value: "domain.size[1]", "species[0].restitution". Messages show it without the table's
/// number.
class Diagnostics {
 public:
  /// For a scene without a text: errors have no place.
  Diagnostics() = default;
  Diagnostics(std::string file_name, const Node& root);

  /// An error of the value at `path`; when the text has no such value, it is placed at the table that lacks
  /// it.
  void report(const std::string& path, const std::string& message);
  void report_at(Place place, const std::string& path, const std::string& message);

  /// No error so far in the value at `path`, in what it holds or in what holds it.
  bool clean(const std::string& path) const;

  /// Throws InputError when there is any error, sorted by place.
  void raise() const;

 private:
  struct Entry {
    Place place;
    std::string path;
    std::string message;
  };
  void remember(const Node& node, const std::string& path);
  Place find(std::string path) const;

  std::string file_name_;
  std::map<std::string, Place> places_;
  std::vector<Entry> entries_;
  std::unordered_set<std::string> reported_, holders_;  ///< paths with an error; those and all that hold them
};

/// "domain" + "size" -> "domain.size"; "" + "run" -> "run"
std::string join_path(const std::string& path, const std::string& key);
/// "observe" + 2 -> "observe[2]"
std::string item_path(const std::string& path, std::size_t index);
/// "'species.restitution'" for "species[0].restitution"
std::string shown(const std::string& path);

}  // namespace sandglass
