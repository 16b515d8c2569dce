#include "sim/base/error.hpp"
#include "sim/base/test_fuzz.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/test_mutator.hpp"

#include <array>

#include <gtest/gtest.h>

// Property: whatever the text, the reader returns a scene that keeps the rules and survives writing, or
// throws InputError with at least one error. Spoiled scenes come from a fixed seed.

namespace sandglass::fuzz_test {
namespace {

const std::string good = R"(title = "good"
[run]
seed = 1
duration = { collisions-per-particle = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
[domain.sides]
y = ["specular", "open"]
[[species]]
name = "bead"
area-fraction = 0.2
restitution = 0.9
[[source]]
rate = 0.5
height = 2.0
centre = [5.0]
[[inflow]]
side = "y-high"
number-density = 0.1
velocity = [0.0, -1.0]
temperature = 0.5
arrivals = "even"
[method]
preset = "cuba"
density-window = 3
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

const std::string good_event_driven = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.y = "specular"
[[species]]
name = "small"
tangential-restitution = 0.5
friction = 0.2
moment-of-inertia = 0.5
[[species]]
name = "large"
diameter = 2.0
[[wall]]
side = "y-low"
restitution = 0.8
amplitude = 0.5
frequency = 2.0
[[wall]]
side = "y-high"
rule = "thermal"
temperature = 2.0
velocity = [1.0, 0.0]
[[obstacle]]
centre = [5.0, 10.0]
radius = 1.0
rule = "bounce-back"
probability = 0.5
[method]
preset = "event-driven"
collapse-guard = "velocity-dependent"
reference-speed = 1e-2
time-step = 0.1
[initial]
positions = "given"
[[particle]]
position = [0.25, 4.1]
velocity = [1.0, 0.0]
spin = -2.0
[[particle]]
position = [5.0, 1.0]
velocity = [0.0, 1.0]
species = "large"
[[observe]]
what = "rotational-energy"
[output]
event-trace = "events.csv"
)";

const std::string good_regions = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.x = "open"
[[species]]
count = 100
diameter = 0.1
[[source]]
rate = 0.5
centre = [5.0, 3.0]
width = [2.0, 1.0]
[[region]]
low = [0.0, 0.0]
high = [10.0, 4.0]
weight = 2.0
[[region]]
low = [0.0, 8.0]
high = [10.0, 12.0]
weight = 0.25
[method]
preset = "dsmc"
cells = [5, 10]
weight = 0.5
time-step = 0.1
[[observe]]
what = "cloning"
[[observe]]
what = "fields"
grid = [1, 10]
)";

/// A stream from a dispenser to a filter.
const std::string good_stream = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [60.0, 20.0]
sides.x = "open"
[[species]]
area-fraction = 0.5
[[inflow]]
side = "x-low"
entry = "dispenser"
piston = "thermal"
number-density = 0.6366
velocity = [0.2, 0.0]
temperature = 1.0
[[outflow]]
side = "x-high"
velocity = [0.2, 0.0]
temperature = 1.0
filter = 3.0
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "lattice"
)";

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

class Fuzz : public testing::TestWithParam<std::string> {};

std::string method_name(const testing::TestParamInfo<std::string>& scene) {
  return std::array{"Cuba", "EventDriven", "Regions", "Stream"}.at(scene.index);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Fuzz, testing::Values(good, good_event_driven, good_regions, good_stream),
                         method_name);

TEST_P(Fuzz, ASpoiledSceneIsReadOrRefusedAndNothingElse) {
  int accepted = 0, refused = 0;
  Trials trials(5000);
  while (trials.next()) {
    const std::string text = Mutator(trials.seed()).spoil(GetParam());
    try {
      ++(read_spoiled(text) == Outcome::accepted ? accepted : refused);
    } catch (const std::exception& other) {
      FAIL() << "threw something else: " << other.what() << "\nfor\n" << text;
    }
  }
  if (trials.timed()) return;
  EXPECT_GT(accepted, 50);  // both ways are well trodden
  EXPECT_GT(refused, 1000);
}

TEST_P(Fuzz, TheSceneThatIsSpoiledIsGood) { EXPECT_EQ(read_spoiled(GetParam()), Outcome::accepted); }

TEST(FuzzDeep, DeepNestingIsRefused) {
  EXPECT_EQ(read_spoiled("a = " + std::string(100000, '[')), Outcome::refused);
}

}  // namespace
}  // namespace sandglass::fuzz_test
