#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/program/folders.hpp"
#include "sim/program/options.hpp"
#include "sim/program/scene_page.hpp"

#include <cctype>
#include <set>

#include <fmt/format.h>

namespace sandglass::program {

namespace {
/// "Top level" and "Intervals" are headings of the page, not tables of a scene.
bool is_table(const std::string& section) {
  return std::islower(static_cast<unsigned char>(section.front())) != 0;
}

void print(const KeyEntry& entry, const std::string& section) {
  fmt::print("{}\n", is_table(section) ? section + "." + entry.key : entry.key);
  for (const auto& [head, cell] : entry.cells)
    if (!cell.empty()) fmt::print("  {:<12} {}\n", head, cell);
}

void print_overview(const std::vector<PageSection>& page) {
  for (const PageSection& section : page) {
    std::string keys;
    std::set<std::string> named;
    for (const KeyEntry& entry : section.keys)
      if (named.insert(entry.key).second) keys += (keys.empty() ? "" : ", ") + entry.key;
    fmt::print("{}\n  {}\n", section.name, keys);
  }
  fmt::print("\nsandglass help SECTION or KEY says more, as in: sandglass help species.restitution\n");
}

/// "key", "section.key", or a section; whether anything was found.
bool print_found(const std::vector<PageSection>& page, const std::string& word) {
  bool found = false;
  for (const PageSection& section : page)
    for (const KeyEntry& entry : section.keys) {
      if (word != section.name && word != entry.key && word != section.name + "." + entry.key) continue;
      print(entry, section.name);
      found = true;
    }
  return found;
}

std::vector<std::string> known_words(const std::vector<PageSection>& page) {
  std::set<std::string> words;
  for (const PageSection& section : page) {
    words.insert(section.name);
    for (const KeyEntry& entry : section.keys) words.insert({entry.key, section.name + "." + entry.key});
  }
  return {words.begin(), words.end()};
}
}  // namespace

int help(const Options& options) {
  const std::vector<PageSection> page = read_scene_page(scene_page());
  if (options.subject.empty()) {
    print_overview(page);
    return all_well;
  }
  if (print_found(page, options.subject)) return all_well;
  const std::string near = nearest_spelling(options.subject, known_words(page));
  throw InputError(fmt::format("no section or key '{}' in a scene{}; `sandglass help` lists all",
                               options.subject, near.empty() ? "" : "; did you mean '" + near + "'?"));
}

}  // namespace sandglass::program
