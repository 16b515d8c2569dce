#include "sim/base/error.hpp"
#include "sim/scene/scene.hpp"

#include <random>

#include <gtest/gtest.h>

// Property: whatever the text, the reader returns a scene that keeps the rules and survives writing, or
// throws InputError with at least one fault. Spoiled scenes come from a fixed seed.

namespace sandglass {
namespace {

const std::string good = R"(title = "good"
[run]
seed = 1
duration = { collisions-per-particle = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
[domain.sides]
y = ["specular", "specular"]
[[species]]
name = "bead"
area-fraction = 0.2
restitution = 0.9
[method]
preset = "cuba"
random-offset = 0.25
cells = [5, 10]
time-step = { collisions-per-particle = 0.1 }
[forces]
gravity = [0.0, -1.0]
[initial]
positions = "lattice"
velocity = [0.0, 0.0]
[[observe]]
what = "crossings"
every = { time = 2.0 }
position = 5.0
range = [-3.0, 3.0]
[[observe]]
what = "fields"
grid = [1, 10]
[output]
trajectory = { steps = 10 }
)";

const std::vector<std::string> scraps = {"[",
                                         "]",
                                         "{",
                                         "}",
                                         "\"",
                                         "'",
                                         "\n",
                                         "=",
                                         ".",
                                         ",",
                                         "#",
                                         "-",
                                         "_",
                                         "\\",
                                         "0",
                                         "9",
                                         "e",
                                         "nan",
                                         "inf",
                                         "-1",
                                         "1e400",
                                         "true",
                                         "[[",
                                         "]]",
                                         "2020-01-01",
                                         "\xff",
                                         "\xc3\xa9",
                                         std::string(1, '\0'),
                                         "99999999999999999999",
                                         "0x",
                                         "x"};

class Mutator {
 public:
  explicit Mutator(unsigned seed) : engine_(seed) {}

  std::string spoil(std::string text) {
    const std::size_t edits = 1 + below(4);
    for (std::size_t edit = 0; edit < edits; ++edit)
      text = below(2) ? spoil_characters(text) : spoil_lines(text);
    return text;
  }

 private:
  /// std::uniform_int_distribution is not the same on every library; the bias of a remainder is no matter
  /// here.
  std::size_t below(std::size_t bound) { return engine_() % bound; }

  std::string spoil_characters(std::string text) {
    if (text.empty()) return text;
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(8);
    switch (below(3)) {
      case 0:
        return text.erase(at, length);
      case 1:
        return text.insert(at, text.substr(at, length));
      default:
        return text.replace(at, below(2), scraps[below(scraps.size())]);
    }
  }

  std::string spoil_lines(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char character : text) {
      lines.back() += character;
      if (character == '\n') lines.emplace_back();
    }
    const std::size_t from = below(lines.size()), to = below(lines.size());
    switch (below(3)) {
      case 0:
        lines[from].clear();
        break;
      case 1:
        lines[to] += lines[from];
        break;
      default:
        std::swap(lines[from], lines[to]);
        break;
    }
    std::string joined;
    for (const std::string& line : lines) joined += line;
    return joined;
  }

  std::mt19937 engine_;
};

enum class Outcome { accepted, refused };

Outcome read_spoiled(const std::string& text) {
  Scene scene;
  try {
    scene = read_scene_text(text, "spoiled.toml");
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_GT(diagnostic.line, 0) << diagnostic.text() << '\n' << text;
      EXPECT_FALSE(diagnostic.message.empty());
    }
    return Outcome::refused;
  }
  EXPECT_EQ(read_scene_text(write_scene(scene), "written.toml"), scene) << text;
  return Outcome::accepted;
}

TEST(Fuzz, ASpoiledSceneIsReadOrRefusedAndNothingElse) {
  Mutator mutator(20240607);
  int accepted = 0, refused = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const std::string text = mutator.spoil(good);
    try {
      ++(read_spoiled(text) == Outcome::accepted ? accepted : refused);
    } catch (const std::exception& other) {
      FAIL() << "threw something else: " << other.what() << "\nfor\n" << text;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(accepted, 100);  // both ways are well trodden
  EXPECT_GT(refused, 1000);
}

TEST(Fuzz, TheSceneThatIsSpoiledIsGood) { EXPECT_EQ(read_spoiled(good), Outcome::accepted); }

TEST(Fuzz, DeepNestingIsRefused) {
  EXPECT_EQ(read_spoiled("a = " + std::string(100000, '[')), Outcome::refused);
}

}  // namespace
}  // namespace sandglass
