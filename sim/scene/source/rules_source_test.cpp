#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_source_test {
namespace {

const std::string good = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [40.0, 30.0]
[domain.sides]
x = "open"
y = ["specular", "open"]
[[species]]
count = 0
restitution = 0.9
[[obstacle]]
centre = [10.0, 10.0]
radius = 2.0
[[source]]
rate = 1.5
count = 100
height = 5.0
centre = [20.0]
width = [2.0]
velocity = [0.0, -1.0]
[[source]]
rate = 2.0
centre = [30.0, 20.0]
[method]
preset = "dsmc"
cell-size = 2.0
time-step = 0.1
[forces]
gravity = [0.0, -1.0]
)";

TEST(Sources, AreReadAndWritten) {
  const Scene scene = read_scene_text(good, "scene.toml");
  ASSERT_EQ(scene.sources.size(), 2u);
  EXPECT_EQ(scene.sources[0], (Source{1.5, 100, 5, {20}, {2}, {0, -1}}));
  EXPECT_EQ(scene.sources[1], (Source{2, {}, {}, {30, 20}, {}, {}}));
  EXPECT_EQ(read_scene_text(write_scene(scene), "again"), scene);
  EXPECT_EQ(particle_count(scene), 0u);
  EXPECT_EQ(poured_count(scene), 100u + 200);
  EXPECT_TRUE(has_open_side(scene.domain));
  EXPECT_EQ(scene.domain.sides[1], (std::array{Side::specular, Side::open}));
}

class SourceErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(SourceErrors, AreRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> errors = {
    {"no_rate", "rate = 1.5\n", "", "15:1", {"missing 'source.rate'", "particles per time"}},
    {"rate", "rate = 1.5", "rate = 0.0", "16:8", {"'source.rate' is 0; allowed: above 0"}},
    {"flood", "rate = 1.5", "rate = 1e9", "16:8", {"pours 100000000 particles in one step", "at most"}},
    {"crowded",
     "rate = 1.5",
     "rate = 5.0",
     "16:8",
     {"pours 2.57", "while one falls out of the way", "lower the rate to 1.945", "'velocity' of 1.414"}},
    {"two_heights",
     "centre = [30.0, 20.0]",
     "height = 2.0\ncentre = [30.0]",
     "24:10",
     {"one source may stand above the pile"}},
    {"no_count", "count = 100", "count = 0", "17:9", {"'source.count' is 0; allowed: 1 to"}},
    {"height", "height = 5.0", "height = -5.0", "18:10", {"'source.height' is -5; allowed: above 0"}},
    {"no_gravity",
     "[forces]\ngravity = [0.0, -1.0]\n",
     "",
     "18:10",
     {"'source.height' is counted above the pile", "gravity along one axis"}},
    {"two_gravities", "gravity = [0.0, -1.0]", "gravity = [0.5, -1.0]", "18:10", {"gravity along one axis"}},
    {"coordinate_of_gravity",
     "centre = [20.0]",
     "centre = [20.0, 20.0]",
     "19:10",
     {"'source.centre' has 2 components; it needs 1", "but that of gravity"}},
    {"width", "width = [2.0]", "width = [-2.0]", "20:10", {"'source.width' is -2; allowed: 0 or more"}},
    {"no_coordinate", "[30.0, 20.0]", "[30.0]", "24:10", {"has 1 component; it needs 2"}},
    {"upwards", "[0.0, -1.0]\n[[", "[0.0, 1.0]\n[[", "21:12", {"points against gravity"}},
    {"velocity_of_3d", "[0.0, -1.0]\n[[", "[0.0, -1.0, 0]\n[[", "21:12", {"has 3 components"}},
    {"above_the_box",
     "[30.0, 20.0]",
     "[30.0, 31.0]",
     "24:17",
     {"the source reaches from 31 to 31 along y", "allowed: 0 to 30"}},
    {"beside_the_box", "centre = [20.0]", "centre = [0.5]", "19:11", {"from -0.5 to 1.5 along x"}},
    {"in_a_wall",
     "[30.0, 20.0]",
     "[30.0, 0.5]\n[[wall]]\nside = 'y-low'\namplitude = 1.0\nfrequency = 1.0",
     "24:17",
     {"along y, out of the domain or into a wall; allowed: 1 to 30"}},
    {"behind_a_wall",  // all is poured by time 50, of 100
     "[30.0, 20.0]",
     "[30.0, 4.0]\ncount = 100\n[[wall]]\nside = 'y-low'\nvelocity = [0.0, 0.1]",
     "24:17",
     {"along y, out of the domain or into a wall; allowed: 5 to 30"}},
    {"too_fast", "[0.0, -1.0]\n[[", "[0.0, -1e308]\n[[", "21:18", {"is -1e+308; allowed: -1e+100 to 1e+100"}},
    {"in_an_obstacle",
     "[30.0, 20.0]",
     "[11.0, 11.0]",
     "24:10",
     {"reaches into an obstacle of radius 2", "move 'source.centre'"}},
    {"unknown_key", "width = [2.0]", "widht = [2.0]", "20:1", {"did you mean 'width'?"}},
    {"no_cells",
     "cell-size = 2.0\n",
     "",
     "25:1",
     {"with a [[source]]", "'method.cells' or 'method.cell-size'"}},
    {"no_temperature",
     "time-step = 0.1",
     "time-step = { collisions-per-particle = 0.1 }",
     "28:13",
     {"follows from the collisions", "starts without one: give it as a time"}},
    {"no_speed",
     "time-step = 0.1",
     "time-step = { cell-fraction = 0.1 }",
     "28:13",
     {"follows from the speeds", "starts without one: give it as a time"}},
};

INSTANTIATE_TEST_SUITE_P(Source, SourceErrors, testing::ValuesIn(errors), edit_name);

const std::string fixed = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [40.0, 30.0]
sides = { x = "specular", y = "specular" }
[[species]]
count = 10
[method]
preset = "mixing"
time-step = 0.1
)";

TEST(Sources, NeedAMethodWhoseNumberMayChange) {
  expect_refused(fixed, {"",
                         "",
                         "[[source]]\nrate = 1\ncentre = [1, 1]\n",
                         "12:1",
                         {"'source' cannot be used with the method 'mixing', only with", "'dsmc'"}});
}

/// Particles with a surface need room for it.
const std::string hard = spoiled(
    spoiled(spoiled(good, {"", "preset = \"dsmc\"\ncell-size = 2.0", "preset = \"event-driven\"", "", {}}),
            {"", "count = 0", "count = 0\ndiameter = 1.5", "", {}}),
    {"", "rate = 1.5", "rate = 1.2", "", {}});

class HardSources : public testing::TestWithParam<BadEdit> {};

TEST_P(HardSources, AreRefusedWithPlaceAndReason) { expect_refused(hard, GetParam()); }

const std::vector<BadEdit> hard_errors = {
    {"in_a_wall", "[30.0, 20.0]", "[30.0, 0.7]", "25:17", {"into a wall; allowed: 0.75 to 29.25"}},
    {"in_an_obstacle", "[30.0, 20.0]", "[12.5, 10.0]", "25:10", {"reaches into an obstacle of radius 2"}},
    {"low", "height = 5.0", "height = 1.4", "19:10", {"'source.height' is 1.4; allowed: 1.5 or more"}},
};

INSTANTIATE_TEST_SUITE_P(Source, HardSources, testing::ValuesIn(hard_errors), edit_name);

TEST(OpenSides, AreNeitherPeriodicNorWalled) {
  expect_refused(
      good,
      {"", "x = \"open\"", "x = [\"open\", \"periodic\"]", "7:5", {"one periodic side and one open one"}});
  expect_refused(good,
                 {"", "", "[[wall]]\nside = 'x-low'\n", "32:8", {"'wall.side' is 'x-low', which is open"}});
}

}  // namespace
}  // namespace sandglass::rules_source_test
