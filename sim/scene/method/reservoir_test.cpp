#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::reservoir_test {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
[[species]]
number-density = 1.0
[method]
preset = "reservoir"
time-step = 0.5
[initial]
velocity = [-0.5, 0.0]
[[observe]]
what = "crossings"
every = { steps = 5 }
position = 5.0
)";

class Reservoir : public testing::TestWithParam<BadEdit> {};

TEST_P(Reservoir, HasNoUseForParticlesInABox) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> edits = {
    {"count", "number-density = 1.0", "count = 100", "6:1", {"needs 'number-density'"}},
    {"walls",
     "size =",
     "sides.y = 'specular'\nsize =",
     "5:1",
     {"'domain.sides' cannot be used with the method 'reservoir', only with 'dsmc'"}},
    {"gravity",
     "[initial]",
     "[forces]\ngravity = [0, -1]\n[initial]",
     "12:11",
     {"'forces.gravity' cannot be used with the method 'reservoir'"}},
    {"positions",
     "[initial]",
     "[initial]\npositions = 'lattice'",
     "12:13",
     {"'initial.positions' cannot be used", "holds no particles"}},
    {"exact",
     "[initial]",
     "[initial]\nexact = false",
     "12:9",
     {"'initial.exact' cannot be used", "holds no particles"}},
    {"shear",
     "[initial]",
     "[initial]\nshear-wave = { amplitude = 1 }",
     "12:14",
     {"'initial.shear-wave' cannot be used", "holds no particles"}},
    {"equilibrate",
     "[initial]",
     "[initial]\nequilibrate-collisions-per-particle = 1",
     "12:39",
     {"no collisions"}},
    {"factor", "[initial]", "contact-factor = 'local'\n[initial]", "11:1", {"has no collisions; remove it"}},
    {"offset", "[initial]", "offset = 'consistent'\n[initial]", "11:1", {"has no collisions; remove it"}},
    {"cells", "[initial]", "cells = [5, 5]\n[initial]", "11:1", {"has no cells"}},
    {"cell_size", "[initial]", "cell-size = 1\n[initial]", "11:1", {"has no cells"}},
    {"time_step",
     "0.5\n[",
     "{ collisions-per-particle = 1 }\n[",
     "10:13",
     {"has no collisions to count", "use a time"}},
    {"observer",
     "",
     "[[observe]]\nwhat = 'energy'",
     "18:8",
     {"the observer 'energy' needs particles in a box"}},
    {"cadence",
     "steps = 5",
     "collisions-per-particle = 5",
     "15:9",
     {"no collisions to count: use a time or steps"}},
    {"duration", "time = 10.0", "collisions-per-particle = 5", "2:12", {"no collisions to count"}},
    {"trajectory",
     "",
     "[output]\ntrajectory = { steps = 1 }",
     "18:14",
     {"'output.trajectory' cannot be used", "holds no particles"}},
    {"ids", "", "[output]\nids = true", "18:7", {"'output.ids' cannot be used", "holds no particles"}},
    {"checkpoint", "", "[output]\ncheckpoint = { steps = 1 }", "18:14", {"no state to keep"}},
};

INSTANTIATE_TEST_SUITE_P(Rules, Reservoir, testing::ValuesIn(edits), edit_name);

TEST(ReservoirAlone, ReadsRecordsThatNameTheAbsenceOfCollisions) {
  const std::string old = "contact-factor = 'none'\ndensity = 'smoothed'\noffset = 'none'\n[initial]";
  EXPECT_EQ(read_scene_text(spoiled(good, {"", "[initial]", old, "", {}}), ""), read_scene_text(good, ""));
}

TEST(ReservoirAlone, NeedsCrossings) {
  const std::string text = good.substr(0, good.find("[[observe]]"));
  try {
    read_scene_text(text, "scene.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("needs the observer 'crossings'"));
  }
}

}  // namespace
}  // namespace sandglass::reservoir_test
