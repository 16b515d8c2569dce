#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_inflow_test {
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
name = "light"
count = 0
diameter = 0.1
tangential-restitution = 0.5
[[species]]
name = "heavy"
count = 0
mass = 4.0
diameter = 0.2
[[inflow]]
side = "x-low"
species = "heavy"
number-density = 1.5
velocity = [2.0, 0.5]
temperature = 0.25
spin-temperature = 0.125
arrivals = "even"
[[inflow]]
side = "y-high"
number-density = 2.0
temperature = 1.0
[method]
preset = "dsmc"
cell-size = 2.0
time-step = 0.1
)";

TEST(Inflows, AreReadAndWritten) {
  const Scene scene = read_scene_text(good, "scene.toml");
  ASSERT_EQ(scene.inflows.size(), 2u);
  EXPECT_EQ(scene.inflows[0], (Inflow{0, false, 1, 1.5, {2, 0.5}, 0.25, 0.125, Arrivals::even}));
  EXPECT_EQ(scene.inflows[1], (Inflow{1, true, 0, 2, {}, 1, 0, Arrivals::poisson}));
  EXPECT_EQ(read_scene_text(write_scene(scene), "again"), scene);
  EXPECT_EQ(added_count(scene), 1200 * 3.5);
}

/// Of the gas at rest half of the particles move in, at the mean of |v|, sqrt(2 T/(pi m)).
TEST(Inflows, LetInTheFluxOfTheirStream) {
  const Scene scene = read_scene_text(good, "scene.toml");
  EXPECT_NEAR(inflow_rate(scene, scene.inflows[1]), 40 * 2 * std::sqrt(2 / M_PI) / 2, 1e-12);
  EXPECT_NEAR(inflow_rate(scene, scene.inflows[0]), 30 * 1.5 * 2, 1e-9) << "eight thermal speeds";
}

/// Beyond x-high the same streams would send in what moves against them.
TEST(Inflows, TellWhatAVacuumLacks) {
  const Scene scene = read_scene_text(good, "scene.toml");
  const double entering = 1.5 * 2 + 2 / std::sqrt(2 * M_PI);
  EXPECT_NEAR(neglected_return(scene, 0, true) * entering, 2 / std::sqrt(2 * M_PI), 1e-9);
}

class InflowErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(InflowErrors, AreRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> errors = {
    {"no_side", "side = \"x-low\"\n", "", "19:1", {"missing 'inflow.side'", "'z-high'"}},
    {"side_of_3d", "\"x-low\"", "\"z-low\"", "20:8", {"'inflow.side' is 'z-low'", "has the axes x and y"}},
    {"wall",
     "\"x-low\"",
     "\"y-low\"",
     "20:8",
     {"'inflow.side' is 'y-low', which is a wall", "[domain.sides] y = \"open\""}},
    {"periodic", "x = \"open\"", "x = \"periodic\"", "20:8", {"'x-low', which is periodic"}},
    {"species", "species = \"heavy\"", "species = \"havy\"", "21:11", {"did you mean 'heavy'?"}},
    {"no_density", "number-density = 1.5\n", "", "19:1", {"missing 'inflow.number-density'"}},
    {"density",
     "density = 1.5",
     "density = 0.0",
     "22:18",
     {"'inflow.number-density' is 0; allowed: above 0"}},
    {"packing",
     "density = 1.5",
     "density = 30.0",
     "22:18",
     {"what comes in by 'x-low' has the area-fraction 0.9425", "close packing (0.9069)", "lower"}},
    {"flood",
     "density = 1.5\nvelocity = [2.0, 0.5]",
     "density = 1.5\nvelocity = [2e6, 0.5]",
     "22:18",
     {"particles come in by 'x-low' in one step", "shorten 'method.time-step'"}},
    {"velocity_of_3d", "[2.0, 0.5]", "[2.0, 0.5, 0]", "23:12", {"has 3 components"}},
    {"infinite", "[2.0, 0.5]", "[inf, 0.5]", "23:13", {"a finite number"}},
    {"no_temperature", "temperature = 1.0\n", "", "27:1", {"missing 'inflow.temperature'", "0 is a beam"}},
    {"temperature", "temperature = 1.0", "temperature = -1.0", "30:15", {"is -1; allowed: 0 or more"}},
    {"spins", "spin-temperature = 0.125", "spin-temperature = -1.0", "25:20", {"is -1; allowed: 0 or more"}},
    {"smooth",
     "tangential-restitution = 0.5\n",
     "",
     "24:20",
     {"'inflow.spin-temperature' needs rough contacts"}},
    {"arrivals", "\"even\"", "\"evne\"", "26:12", {"unknown way to arrive 'evne'; did you mean 'even'?"}},
    {"beam_away",
     "temperature = 1.0",
     "temperature = 0.0",
     "27:1",
     {"nothing comes in by 'y-high'", "point 'velocity' into the box"}},
    {"against_the_stream",
     "velocity = [2.0, 0.5]",
     "velocity = [-50.0, 0.5]",
     "23:12",
     {"at temperature 0.25 no particle moves against this stream"}},
    {"unknown_key", "spin-temperature = 0.125", "spin-temprature = 0.125", "25:1", {"did you mean"}},
    {"moving_wall",
     "",
     "[[wall]]\nside = \"y-low\"\namplitude = 1.0\nfrequency = 1.0\n",
     "20:8",
     {"the wall 'y-low' moves over the side"}},
    {"no_cells", "cell-size = 2.0\n", "", "31:1", {"an [[inflow]]", "'method.cells' or 'method.cell-size'"}},
    {"no_step",
     "time-step = 0.1",
     "time-step = { cell-fraction = 0.1 }",
     "34:13",
     {"follows from the speeds", "starts without one: give it as a time"}},
};

INSTANTIATE_TEST_SUITE_P(Inflow, InflowErrors, testing::ValuesIn(errors), edit_name);

TEST(Inflows, NeedAMethodWhoseNumberMayChange) {
  expect_refused(R"([run]
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
)",
                 {"",
                  "",
                  "[[inflow]]\nside = 'x-low'\nnumber-density = 1.0\ntemperature = 1.0\n",
                  "12:1",
                  {"'inflow' cannot be used with the method 'mixing', only with", "'dsmc'"}});
}

}  // namespace
}  // namespace sandglass::rules_inflow_test
