#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_test {
namespace {

const std::string good = R"(title = "good"
[run]
seed = 1
replicas = 2
duration = { collisions-per-particle = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.x = "periodic"
sides.y = "specular"
[[species]]
name = "bead"
area-fraction = 0.2
diameter = 1.0
mass = 1.0
restitution = 0.9
[method]
preset = "cba"
cells = [5, 10]
time-step = { collisions-per-particle = 0.1 }
weight = 1.0
[forces]
gravity = [0.0, -1.0]
[initial]
positions = "random"
temperature = 1.0
velocity = [0.0, 0.0]
[[observe]]
what = "crossings"
every = { time = 2.0 }
position = 5.0
range = [-3.0, 3.0]
bins = 10
[[observe]]
what = "fields"
grid = [1, 10]
)";

class Rules : public testing::TestWithParam<BadEdit> {};

TEST_P(Rules, IsRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> run_and_domain = {
    {"no_replicas", "replicas = 2", "replicas = 0", "4:12", {"'run.replicas' is 0; allowed: 1 to 1000000"}},
    {"no_duration", "= 10.0 }", "= 0 }", "5:40", {"is 0; allowed: above 0"}},
    {"endless", "= 0.1 }", "= 1e-300 }", "20:13", {"makes 1e+301 steps of 'run.duration'; at most 9e+15"}},
    {"overshoots", "= 0.1 }", "= 20.0 }", "20:13", {"is 2 times as long as 'run.duration'", "shorten it"}},
    {"other_case", "restitution", "RESTITUTION", "16:1", {"did you mean 'restitution'?"}},
    {"no_steps", "collisions-per-particle = 10.0", "steps = 0", "5:22", {"'run.duration.steps' is 0"}},
    {"many_steps", "collisions-per-particle = 10.0", "steps = 9000000000000001", "5:22", {"allowed: 1 to"}},
    {"cadence", "time = 2.0", "time = -2.0", "30:18", {"'observe.every.time' is -2; allowed: above 0"}},
    {"trajectory", "", "[output]\ntrajectory.steps = 0", "38:20", {"'output.trajectory.steps' is 0"}},
    {"dimension", "dimension = 2", "dimension = 4", "7:13", {"'domain.dimension' is 4; allowed: 2 to 3"}},
    {"negative_size", "20.0]", "-20.0]", "8:15", {"'domain.size' is -20; allowed: above 0"}},
    {"sizes_of_3d", "20.0]", "20.0, 5.0]", "8:8", {"has 3 components, but the scene has 2 dimensions"}},
    {"one_wall", "\"specular\"", "[\"specular\", \"periodic\"]", "10:11", {"one periodic side and one wall"}},
    {"gravity_of_3d", "[0.0, -1.0]", "[0, 0, -1]", "23:11", {"'forces.gravity' has 3 components"}},
    {"gravity_along_periodic",
     "[0.0, -1.0]",
     "[0.5, -1.0]",
     "23:12",
     {"periodic axis x", "x = \"specular\""}},
};

const std::vector<BadEdit> species = {
    {"name", "\"bead\"", "\"a bead\"", "12:8", {"'species.name' must be a word"}},
    {"restitution_above_1", "0.9", "1.2", "16:15", {"'species.restitution' is 1.2; allowed: 0 to 1"}},
    {"restitution_below_0", "0.9", "-0.1", "16:15", {"is -0.1; allowed: 0 to 1"}},
    {"diameter", "diameter = 1.0", "diameter = 0", "14:12", {"'species.diameter' is 0; allowed: above 0"}},
    {"mass", "mass = 1.0", "mass = -1.0", "15:8", {"'species.mass' is -1"}},
    {"fraction", "area-fraction = 0.2", "area-fraction = -0.2", "13:17", {"'species.area-fraction' is -0.2"}},
    {"density", "area-fraction = 0.2", "number-density = 0", "13:18", {"'species.number-density' is 0"}},
    {"no_particle", "area-fraction = 0.2", "count = 0", "13:9", {"gives 0 particles; at least 2"}},
    {"one_particle", "area-fraction = 0.2", "count = 1", "13:9", {"gives 1 particle;", "cannot collide"}},
    {"too_dilute", "area-fraction = 0.2", "area-fraction = 1e-5", "13:17", {"gives 0 particles"}},
    {"too_many", "weight = 1.0", "weight = 1e-12", "13:17", {"particles; at most 100000000000"}},
    {"close_packing",
     "area-fraction = 0.2",
     "area-fraction = 0.95",
     "13:17",
     {"at or above close packing (0.9069)"}},
    {"close_by_count",
     "area-fraction = 0.2",
     "count = 240",
     "13:9",
     {"fraction 0.9425", "close packing (0.9069)"}},
    {"random_close", "area-fraction = 0.2", "area-fraction = 0.85", "13:17", {"random close packing (0.82)"}},
};

const std::vector<BadEdit> method = {
    {"time_step",
     "time-step = { collisions-per-particle = 0.1 }",
     "time-step = 0",
     "20:13",
     {"allowed: above 0"}},
    {"step_collisions",
     "= 0.1 }",
     "= -0.1 }",
     "20:41",
     {"'method.time-step.collisions-per-particle' is -0.1"}},
    {"weight", "weight = 1.0", "weight = 0", "21:10", {"'method.weight' is 0; allowed: above 0"}},
    {"tiny_weight", "weight = 1.0", "weight = 1e-300", "21:10", {"allowed: above 0, 1e-100 to 1e+100"}},
    {"huge_size", "20.0]", "1e308]", "8:15", {"'domain.size' is 1e+308; allowed: above 0, 1e-100 to 1e+100"}},
    {"density", "\"cba\"", "\"dsmc\"\ndensity = 'cell'", "19:11", {"contact-factor = \"local\" only"}},
    {"even_window",
     "\"cba\"",
     "\"cba\"\ndensity-window = 4",
     "19:18",
     {"'method.density-window' is 4", "an odd number of cells"}},
    {"no_window", "\"cba\"", "\"cba\"\ndensity-window = 0", "19:18", {"is 0; allowed: an odd number"}},
    {"window_of_a_cell",
     "\"cba\"",
     "\"cba\"\ndensity = 'cell'\ndensity-window = 3",
     "20:18",
     {"density = \"smoothed\" only"}},
    {"window_of_no_factor",
     "\"cba\"",
     "\"dsmc\"\ndensity-window = 3",
     "19:18",
     {"contact-factor = \"local\"", "remove it"}},
    {"random_offset", "\"cba\"", "\"cuba\"\nrandom-offset = -1", "19:17", {"is -1; allowed: 0 to 10"}},
    {"wide_cells", "cells = [5, 10]", "cell-size = 30", "19:13", {"is 30, wider than the domain (10)"}},
    {"zero_cells", "[5, 10]", "[5, 0]", "19:13", {"'method.cells' is 0; allowed: 1 to"}},
    {"cells_of_3d", "[5, 10]", "[5, 10, 5]", "19:9", {"'method.cells' has 3 components"}},
    {"many_cells", "[5, 10]", "[50000, 50000]", "19:9", {"gives 2.5e+09 cells; at most"}},
    {"small_cells", "cells = [5, 10]", "cell-size = 1e-9", "19:13", {"gives 2e+20 cells; at most"}},
};

const std::vector<BadEdit> initial = {
    {"temperature", "temperature = 1.0", "temperature = 0", "26:15", {"'initial.temperature' is 0"}},
    {"velocity", "velocity = [0.0, 0.0]", "velocity = [0.0]", "27:12", {"has 1 component, but"}},
    {"equilibrate",
     "temperature",
     "equilibrate-collisions-per-particle = -1\ntemperature",
     "26:39",
     {"0 or more"}},
    {"shear_wave", "temperature", "shear-wave = { amplitude = 1 }\ntemperature", "26:14", {"along x and y"}},
};

const std::vector<BadEdit> observe = {
    {"axis", "position =", "axis = 'z'\nposition =", "31:8", {"'observe.axis' must be 'x' or 'y'"}},
    {"walled", "position =", "axis = 'y'\nposition =", "31:8", {"normal to a periodic axis; y has walls"}},
    {"plane", "position = 5.0", "position = 10.0", "31:12", {"is 10, outside the domain", "below 10"}},
    {"plane_below", "position = 5.0", "position = -1", "31:12", {"is -1, outside the domain"}},
    {"range", "[-3.0, 3.0]", "[3.0, 3.0]", "32:9", {"goes from 3 to 3"}},
    {"bins", "bins = 10", "bins = 0", "33:8", {"'observe.bins' is 0; allowed: 1 to 1000000"}},
    {"grid", "[1, 10]", "[1, 0]", "36:12", {"'observe.grid' is 0"}},
    {"grid_of_3d", "[1, 10]", "[1, 10, 1]", "36:8", {"'observe.grid' has 3 components"}},
    {"large_grid", "[1, 10]", "[20000, 20000]", "36:8", {"has 400000000 bins; at most"}},
    {"shear_mode", "", "[[observe]]\nwhat = 'shear-mode'", "38:8", {"periodic along x and y"}},
    {"twice", "", "[[observe]]\nwhat = 'fields'\ngrid = [2, 2]", "37:1", {"'fields' is given twice"}},
};

INSTANTIATE_TEST_SUITE_P(RunAndDomain, Rules, testing::ValuesIn(run_and_domain), edit_name);
INSTANTIATE_TEST_SUITE_P(Species, Rules, testing::ValuesIn(species), edit_name);
INSTANTIATE_TEST_SUITE_P(Method, Rules, testing::ValuesIn(method), edit_name);
INSTANTIATE_TEST_SUITE_P(Initial, Rules, testing::ValuesIn(initial), edit_name);
INSTANTIATE_TEST_SUITE_P(Observe, Rules, testing::ValuesIn(observe), edit_name);

/// The good scene with edits that it must bear.
std::string edited(const std::vector<BadEdit>& edits) {
  std::string text = good;
  for (const BadEdit& edit : edits) text = spoiled(text, edit);
  return text;
}

TEST(RulesTogether, TheCorrectedOffsetNeedsRestitution) {
  const std::string text = edited({{"", "\"cba\"", "\"cba-corrected\"", "", {}}});
  expect_refused(text, {"", "= 0.9", "= 0.09", "16:15", {"at least 0.1", "d (1 + r) / (2 r)"}});
}

TEST(RulesTogether, DiluteMethodsMayGoBeyondRandomClosePacking) {
  const BadEdit dense{"", "area-fraction = 0.2", "area-fraction = 0.85", "", {}};
  EXPECT_NO_THROW(read_scene_text(edited({dense, {"", "\"cba\"", "\"dsmc\"", "", {}}}), ""));
}

TEST(RulesTogether, RandomInsertionHasALimit) {
  const std::string text = edited({{"", "\"random\"", "\"random-without-overlap\"", "", {}}});
  expect_refused(
      text, {"", "area-fraction = 0.2", "area-fraction = 0.55", "25:13", {"0.5 at most", "\"lattice\""}});
  expect_refused(text, {"", "weight = 1.0", "weight = 2.0", "25:13", {"needs method.weight = 1"}});
}

TEST(RulesTogether, HistogramsMayDifferInTheirAxis) {
  const std::string histogram = "[[observe]]\nwhat = 'velocity-histogram'\naxis = ";
  EXPECT_NO_THROW(read_scene_text(good + histogram + "'x'\n" + histogram + "'y'\n", ""));
  EXPECT_THROW(read_scene_text(good + histogram + "'x'\n" + histogram + "'x'\n", ""), InputError);
}

TEST(RulesTogether, ASceneMadeInCodeIsCheckedByTheSameRules) {
  Scene scene = read_scene_text(good, "");
  EXPECT_NO_THROW(validate(scene));
  scene.species[0].restitution = std::numeric_limits<double>::quiet_NaN();
  scene.domain.sides.clear();
  scene.method.preset = "best";
  scene.run.duration = {};
  try {
    validate(scene);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    for (const std::string word : {"error: 'species.restitution' is nan", "'domain.sides' has 0 components",
                                   "unknown preset 'best'", "'run.duration' needs exactly one"})
      EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

}  // namespace
}  // namespace sandglass::rules_test
