#include "sim/scene/text/document.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/event_driven.hpp"
#include "sim/scene/method/family.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/words.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

namespace sandglass::document_test {
namespace {

std::string reference() {
  std::ifstream file(SANDGLASS_SOURCE_DIR "/docs/scene.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

void collect_keys(const Node& node, std::set<std::string>& keys) {
  for (const Node& item : node.items) {
    if (!item.key.empty()) keys.insert(item.key);
    collect_keys(item, keys);
  }
}

std::string dotted(int parts) {
  std::string key = "a";
  for (int part = 1; part < parts; ++part) key += ".a";
  return key;
}

std::string parse_failure(const std::string& text) {
  try {
    parse_document(text, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// Such a key, or the header of such a table, ended the program.
TEST(Document, RefusesAKeyOfManyParts) {
  const std::string refusal = "scene.toml:2:128: error: a key of more than 64 parts";
  for (const std::string& tail : {std::string(" = 1\n"), std::string("\n")})
    for (const int parts : {65, 30000})
      EXPECT_EQ(parse_failure("b = 1\n" + dotted(parts) + tail).rfind(refusal, 0), 0u) << parts;
  EXPECT_NE(parse_failure("[" + dotted(30000) + "]\n"), "none");
  EXPECT_NE(parse_failure("b = {" + dotted(30000) + " = 1}\n"), "none");
  EXPECT_EQ(parse_failure(dotted(64) + " = 1\n"), "none");
}

TEST(Document, TakesDotsInTextsAndComments) {
  const std::string dots(100, '.');
  for (const std::string& text : std::initializer_list<std::string>{
           "# " + dots + "\nb = 1\n", "b = \"" + dots + "\"\n", "b = '" + dots + "' # " + dots,
           "b = \"\\\"" + dots + "\"\n", "b = \"\"\"\n\"" + dots + "\"\n\"\"\"\n", "b = [1.0, 2.0]"})
    EXPECT_EQ(parse_failure(text), "none") << text;
}

TEST(Document, KeepsTheOrderAndThePlacesOfTheText) {
  const Node root = parse_document("b = 1\n[t]\n  a = [2.5, 'x']\n", "");
  ASSERT_EQ(root.items.size(), 2U);
  EXPECT_EQ(root.items[0].key, "b");
  EXPECT_EQ(root.items[0].place, (Place{1, 5}));
  const Node& list = root.items[1].items.at(0);
  EXPECT_EQ(list.key_place, (Place{3, 3}));
  EXPECT_EQ(list.items.at(0).number, 2.5);
  EXPECT_EQ(list.items.at(1).text, "x");
  EXPECT_EQ(list.items.at(1).place, (Place{3, 13}));
}

void add_event_driven(Scene& scene) {
  choose(scene.method, "event-driven");
  const auto rules = surface_kind_words();
  for (const auto& [name, rule] : rules) {
    const SurfaceRule surface{rule, 1, 1, 1.0, 1, 1};
    scene.walls.push_back({0, false, surface, {1, 0, 0}, 1, 1});
    scene.obstacles.push_back({{1, 1, 1}, 1, surface});
  }
  scene.output.event_trace = "x";
  scene.given = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0}};
}

/// Every key that the writer knows stands in the reference.
TEST(Reference, NamesEveryKeyPresetAndObserver) {
  const std::string text = reference();
  Scene scene;
  scene.domain = {3, {1, 1, 1}, {{}, {}, {}}};
  scene.species.emplace_back() = {"a", 3, 0.1, 0.1, 1, 1, 1, 0, 1.0, 1.0};
  DsmcOptions dsmc;
  dsmc.offset = Offset::random;
  dsmc.excluded_volume = ExcludedVolume::cells;
  dsmc.densest_fraction = dsmc.cell_size = 1.0;
  dsmc.entry_curve = dsmc.impact_coefficient = {{0}, {0}};
  dsmc.impact = ImpactDistribution::fitted;
  dsmc.cells = {1, 1, 1};
  scene.method.options = dsmc;
  scene.gravity = {0, 0, 1};
  scene.sources = {{1, 1, 1, {1, 1}, {1, 1}, {0, 0, 1}}};
  scene.regions = {{{0, 0, 0}, {1, 1, 1}, 1}};
  scene.initial.velocity = {0, 0, 0};
  scene.initial.shear_wave = ShearWave{};
  scene.output.trajectory = scene.output.checkpoint = Cadence{};
  for (const std::string& what : observer_names()) scene.observe.emplace_back().what = what;
  for (Observe& observe : scene.observe) observe.range = {{0, 1}};
  std::set<std::string> words;
  collect_keys(parse_document(write_scene(scene), ""), words);
  add_event_driven(scene);
  for (const CollapseGuard guard : {CollapseGuard::contact_time, CollapseGuard::velocity_dependent}) {
    scene.method.options = EventDrivenOptions{{guard, 1, 1}};
    collect_keys(parse_document(write_scene(scene), ""), words);
  }
  for (const std::string& name : names_of(surface_kind_words())) words.insert('"' + name + '"');
  for (const std::string& name : names_of(side_words())) words.insert('"' + name + '"');
  for (const std::string& name : names_of(guard_words())) words.insert('"' + name + '"');
  for (const std::string& name : names_of(positions_words())) words.insert('"' + name + '"');
  for (const std::string& name : preset_names()) words.insert(name);
  for (const std::string& word : words) EXPECT_TRUE(text.find("`" + word + "`") != text.npos) << word;
  for (const NamedSummary& observer : observer_summaries())
    EXPECT_TRUE(text.find("`" + observer.name + "` | " + observer.summary) != text.npos) << observer.name;
}

TEST(Reference, ExamplesRead) {
  std::size_t examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SANDGLASS_SOURCE_DIR "/docs/examples")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(read_scene_file(entry.path().string())) << entry.path();
    ++examples;
  }
  EXPECT_GE(examples, 8u);
}

TEST(Reference, ItsSmallSceneReads) {
  const std::string text = reference();
  const std::size_t begin = text.find("```toml\ntitle"), end = text.find("```", begin + 3);
  ASSERT_NE(end, std::string::npos);
  const std::string scene = text.substr(begin + 8, end - begin - 8);
  EXPECT_EQ(read_scene_text(scene, "docs/scene.md").method.preset, "cba");
}

}  // namespace
}  // namespace sandglass::document_test
