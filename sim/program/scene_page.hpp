#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sandglass::program {

/// A key of a scene as docs/scene.md has it: a row of a table, each cell with the head of its column.
struct KeyEntry {
  std::string key;
  std::vector<std::pair<std::string, std::string>> cells;
};

struct PageSection {
  std::string name;  ///< "species"
  std::vector<KeyEntry> keys;
};

/// The sections of the page that have a table of keys. Throws InputError when the page cannot be read.
std::vector<PageSection> read_scene_page(const std::string& path);

}  // namespace sandglass::program
