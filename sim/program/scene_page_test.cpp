#include "sim/program/scene_page.hpp"

#include "sim/base/error.hpp"
#include "sim/program/folders.hpp"
#include "sim/scene/scene.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace sandglass::program::scene_page_test {
namespace {

std::vector<PageSection> page_of(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / "sandglass_scene_page.md";
  std::ofstream(path) << text;
  std::vector<PageSection> page = read_scene_page(path.string());
  std::filesystem::remove(path);
  return page;
}

TEST(ScenePage, HasARowForEachKeyOfATable) {
  const auto page = page_of(
      "## Words\n| `no` | table of keys |\n"
      "### [[wall]]\ntext\n| key | units | meaning |\n|---|---|---|\n"
      "| `a`, `b` | length | see [motion](motion.md), `x|y` |\n| rest |\n");
  ASSERT_EQ(page.size(), 1u);
  EXPECT_EQ(page[0].name, "wall");
  ASSERT_EQ(page[0].keys.size(), 2u);
  EXPECT_EQ(page[0].keys[1].key, "b");
  const std::vector<std::pair<std::string, std::string>> cells = {{"units", "length"},
                                                                  {"meaning", "see motion, x|y"}};
  EXPECT_EQ(page[0].keys[0].cells, cells);
}

/// The keys that the reader itself says a table may have.
std::set<std::string> allowed_in(const std::string& section, const std::string& text) {
  std::string message;
  try {
    read_scene_text(text, "scene.toml");
  } catch (const InputError& error) {
    message = error.what();
  }
  const std::regex line("unknown key '" + section + "[^']*\\.qqqqqqqqqq'; allowed: ([^\n]*)");
  std::smatch found;
  if (!std::regex_search(message, found, line)) return {};
  const std::string list = found[1];
  std::set<std::string> keys;
  const std::regex quoted("'([^']*)'");
  for (std::sregex_iterator at(list.begin(), list.end(), quoted), end; at != end; ++at) keys.insert((*at)[1]);
  return keys;
}

// What the reader knows and the page does not, nobody can look up.
TEST(ScenePage, KnowsEveryKeyThatTheReaderKnows) {
  const auto page = read_scene_page(scene_page());
  for (const PageSection& section : page) {
    if (section.name.find_first_of(" IT") != std::string::npos) continue;  // not a table of a scene
    const bool list = section.name != "run" && section.name != "domain" && section.name != "method" &&
                      section.name != "forces" && section.name != "initial" && section.name != "output";
    const std::string header = list ? "[[" + section.name + "]]" : "[" + section.name + "]";
    const std::string given = section.name == "particle" ? "initial = { positions = \"given\" }\n" : "";
    const auto allowed = allowed_in(section.name, given + header + "\nqqqqqqqqqq = 1\n");
    EXPECT_FALSE(allowed.empty()) << section.name;
    for (const std::string& key : allowed)
      EXPECT_TRUE(std::ranges::any_of(section.keys, [&](const KeyEntry& entry) { return entry.key == key; }))
          << section.name << "." << key;
  }
}

}  // namespace
}  // namespace sandglass::program::scene_page_test
