#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::mixing_test {
namespace {

const std::string kFluids = R"([run]
duration = { steps = 10 }
[domain]
dimension = 2
size = [100.0, 100.0]
sides = { x = "specular", y = "specular" }
[[species]]
name = "heavy"
count = 4
diameter = 20.0
mass = 25.0
[[species]]
name = "light"
count = 12
diameter = 20.0
[method]
preset = "mixing"
time-step = 1e-3
core-exponent = 5
support-blocks = [4, 4]
[forces]
gravity = [0.0, -980.0]
[initial]
positions = "layers"
uniform-velocity = 100.0
[[observe]]
what = "two-fluids"
grid = [1, 2]
)";

class MixingScene : public testing::TestWithParam<BadEdit> {};

TEST_P(MixingScene, IsRefusedWithPlaceAndReason) { expect_refused(kFluids, GetParam()); }

const std::vector<BadEdit> edits = {
    {"periodic",
     "y = \"specular\" }",
     "y = \"periodic\" }",
     "6:31",
     {"'domain.sides.y' must be \"specular\"", "walls on all sides"}},
    {"upwards", "-980.0", "980.0", "22:11", {"must act downwards", "[0, -980]"}},
    {"aslant", "[0.0, -980.0]", "[1.0, -980.0]", "22:11", {"must act downwards"}},
    {"one_row", "[4, 4]", "[4, 1]", "20:22", {"'method.support-blocks' is 1; allowed: 2 to"}},
    {"no_column", "[4, 4]", "[0, 4]", "20:19", {"'method.support-blocks' is 0; allowed: 1 to"}},
    {"three_blocks", "[4, 4]", "[4, 4, 4]", "20:18", {"'method.support-blocks'", "2"}},
    {"nothing_to_support",
     "[forces]\ngravity = [0.0, -980.0]\n",
     "",
     "20:18",
     {"reduces gravity, and there is none", "remove it"}},
    {"diameters",
     "count = 12\ndiameter = 20.0",
     "count = 12\ndiameter = 10.0",
     "15:12",
     {"must be the same"}},
    {"restitution", "mass = 25.0", "restitution = 0.9", "11:15", {"'species.restitution' is not used"}},
    {"exponent", "core-exponent = 5", "core-exponent = 5.5", "19:17", {"whole number"}},
    {"large_exponent", "core-exponent = 5", "core-exponent = 500", "19:17", {"allowed: 0 to 100"}},
    {"softening", "core-exponent = 5", "softening-length = -1.0", "19:20", {"allowed: 0 or more"}},
    {"cutoff", "core-exponent = 5", "cutoff = 0.0", "19:10", {"allowed: above 0"}},
    {"wall_factor", "core-exponent = 5", "wall-speed-factor = 1.1", "19:21", {"allowed: 0 to 1"}},
    {"no_direction",
     "core-exponent = 5",
     "wall-speed-factor = 0.0\nsmallest-length = 0.0",
     "20:19",
     {"must be above 0 where walls take all the speed"}},
    {"key_of_another", "core-exponent = 5", "cells = [2, 2]", "19:1", {"not for 'mixing'; remove it"}},
    {"weight", "core-exponent = 5", "weight = 2.0", "19:10", {"it must be 1"}},
    {"collisions",
     "time-step = 1e-3",
     "time-step = { collisions-per-particle = 0.1 }",
     "18:13",
     {"no collisions to count"}},
    {"wall",
     "[[observe]]",
     "[[wall]]\nside = \"y-low\"\nrestitution = 0.9\n[[observe]]",
     "26:1",
     {"'wall' cannot be used with the method 'mixing'"}},
    {"wall_force", "what = \"two-fluids\"\ngrid = [1, 2]", "what = \"wall-force\"", "27:8", {"remove it"}},
    {"temperature",
     "uniform-velocity = 100.0",
     "uniform-velocity = 100.0\ntemperature = 1.0",
     "26:1",
     {"cannot be used with 'uniform-velocity'"}},
    {"rounding",
     "uniform-velocity = 100.0",
     "velocity-rounding = 0.1",
     "25:1",
     {"is for positions = \"given\""}},
};
INSTANTIATE_TEST_SUITE_P(Edits, MixingScene, testing::ValuesIn(edits), edit_name);

TEST(MixingScene, IsReadAsWritten) {
  const Scene scene = read_scene_text(kFluids, "scene.toml");
  EXPECT_EQ(read_scene_text(write_scene(scene), "written.toml"), scene);
  const auto& options = std::get<MixingOptions>(scene.method.options);
  EXPECT_EQ(options.core_exponent, 5u);
  EXPECT_FALSE(options.cutoff);
  EXPECT_EQ(scene.initial.uniform_velocity, 100);
}

TEST(MixingScene, TakesVelocitiesOfZero) {
  std::string text = kFluids;
  text.replace(text.find("100.0\n[[observe]]"), 5, "0.0");
  EXPECT_EQ(read_scene_text(text, "scene.toml").initial.uniform_velocity, 0);
}

const std::string kTwo = R"([run]
duration = { steps = 10 }
[domain]
dimension = 2
size = [100.0, 100.0]
sides = { x = "specular", y = "specular" }
[[species]]
diameter = 20.0
[method]
preset = "mixing"
time-step = 1e-3
[initial]
positions = "given"
velocity-rounding = 0.005
[[particle]]
position = [50.0, 50.0]
velocity = [1.0, 0.0]
[[particle]]
position = [60.0, 50.0]
velocity = [1.0, 0.0]
)";

class MixingGiven : public testing::TestWithParam<BadEdit> {};

TEST_P(MixingGiven, IsRefusedWithPlaceAndReason) { expect_refused(kTwo, GetParam()); }

const std::vector<BadEdit> given_edits = {
    {"coinciding",
     "[60.0, 50.0]",
     "[50.0, 50.0]",
     "19:12",
     {"particles 1 and 2 (counted from 1) are at the same place", "'method.softening-length' above 0"}},
    {"outside", "[60.0, 50.0]", "[60.0, 101.0]", "19:19", {"outside the domain; allowed: 0 to 100"}},
    {"rounding", "0.005", "-0.005", "14:21", {"allowed: 0 or more"}},
};
INSTANTIATE_TEST_SUITE_P(Edits, MixingGiven, testing::ValuesIn(given_edits), edit_name);

TEST(MixingGiven, MayCoincideWhereSoftened) {
  std::string text = kTwo;
  text.replace(text.find("[60.0, 50.0]"), 12, "[50.0, 50.0]");
  text.replace(text.find("time-step"), 0, "softening-length = 0.1\n");
  EXPECT_NO_THROW(read_scene_text(text, "scene.toml"));
}

TEST(MixingGiven, IsFlat) {
  std::string text = kTwo;
  text.replace(text.find("dimension = 2"), 13, "dimension = 3");
  try {
    read_scene_text(text, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'domain.dimension' must be 2 with the method 'mixing'"));
  }
}

TEST(MixingGiven, IsReadAsWritten) {
  const Scene scene = read_scene_text(kTwo, "scene.toml");
  EXPECT_EQ(read_scene_text(write_scene(scene), "written.toml"), scene);
  EXPECT_EQ(scene.initial.velocity_rounding, 0.005);
}

}  // namespace
}  // namespace sandglass::mixing_test
