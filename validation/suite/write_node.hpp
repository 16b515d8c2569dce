#pragma once

#include "sim/scene/text/document.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// Where a line of a composed text came from.
struct Origin {
  std::string file;
  Place place;
};

/// A value that remembers the file it came from. `items` replaces node.items, which stays empty.
struct OriginNode {
  Node node;
  std::string file;
  std::vector<OriginNode> items;
  OriginNode* entry(const std::string& key);
};
OriginNode with_origin(const Node& node, const std::string& file);

struct ComposedText {
  std::string text;
  std::vector<Origin> origin;  ///< one a line
};

/// A tree as TOML, one value a line.
ComposedText compose_text(const OriginNode& root);

}  // namespace sandglass
