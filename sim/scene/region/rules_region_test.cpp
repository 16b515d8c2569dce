#include "sim/scene/test_bad_scene.hpp"

#include <gtest/gtest.h>

namespace sandglass::rules_region_test {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [4.0, 3.0]
sides.x = "open"
sides.y = "specular"
[[species]]
count = 100
diameter = 1e-6
[[source]]
rate = 1.0
centre = [3.0, 0.5]
width = [1.0, 0.5]
[[region]]
low = [0.0, 1.2]
high = [4.0, 2.1]
weight = 0.5
[[region]]
low = [2.0, 0.0]
high = [4.0, 1.2]
weight = 4.0
[method]
preset = "dsmc"
cells = [8, 10]
weight = 2.0
time-step = 0.1
[[observe]]
what = "cloning"
every = { time = 1.0 }
)";

TEST(Regions, AreReadAndWritten) {
  const Scene scene = read_scene_text(good, "scene.toml");
  ASSERT_EQ(scene.regions.size(), 2u);
  EXPECT_EQ(scene.regions[0], (Region{{0, 1.2}, {4, 2.1}, 0.5}));
  EXPECT_EQ(read_scene_text(write_scene(scene), "again"), scene);
  EXPECT_EQ(lightest_weight(scene), 0.5);
}

TEST(Regions, MayBeASingleCellOrTheWholeBox) {
  const auto with = [](const std::string& find, const std::string& replace) {
    return spoiled(good, {"", find, replace, "", {}});
  };
  EXPECT_NO_THROW(read_scene_text(
      with("low = [0.0, 1.2]\nhigh = [4.0, 2.1]", "low = [0.5, 1.2]\nhigh = [1.0, 1.5]"), "one cell"));
  EXPECT_NO_THROW(read_scene_text(with("low = [0.0, 1.2]\nhigh = [4.0, 2.1]\nweight = 0.5\n[[region]]\nlow = "
                                       "[2.0, 0.0]\nhigh = [4.0, 1.2]",
                                       "low = [0.0, 0.0]\nhigh = [4.0, 3.0]"),
                                  "the box"));
  EXPECT_NO_THROW(read_scene_text(with("weight = 0.5", "weight = 2e-6"), "a millionth"));
}

class RegionErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(RegionErrors, AreRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> errors = {
    {"no_low", "low = [0.0, 1.2]\n", "", "15:1", {"missing 'region.low'"}},
    {"no_high", "high = [4.0, 2.1]\n", "", "15:1", {"missing 'region.high'"}},
    {"no_weight", "weight = 0.5\n", "", "15:1", {"missing 'region.weight'"}},
    {"zero", "weight = 0.5", "weight = 0.0", "18:10", {"'region.weight' is 0; allowed: above 0"}},
    {"negative", "weight = 0.5", "weight = -1.0", "18:10", {"'region.weight' is -1; allowed: above 0"}},
    {"not_a_number", "weight = 0.5", "weight = nan", "18:10", {"'region.weight' is nan"}},
    {"infinite", "weight = 4.0", "weight = inf", "22:10", {"'region.weight' is inf"}},
    {"too_light", "weight = 0.5", "weight = 1e-6", "18:10", {"a millionth of 'method.weight', 2"}},
    {"too_heavy", "weight = 4.0", "weight = 3e6", "22:10", {"to a million times as much"}},
    {"crowd",
     "count = 100\n",
     "count = 50000000000\n",
     "18:10",
     {"if all particles went there they would be 2e+11", "raise it"}},
    {"components", "[0.0, 1.2]", "[0.0, 1.2, 0.0]", "16:7", {"has 3 components", "2 dimensions"}},
    {"place", "[0.0, 1.2]", "[0.0, nan]", "16:13", {"a finite number"}},
    {"outside", "[4.0, 2.1]", "[4.0, 3.3]", "17:8", {"from 1.2 to 3.3 along y", "within 0 to 3"}},
    {"below", "[0.0, 1.2]", "[-0.5, 1.2]", "17:8", {"from -0.5 to 4 along x", "within 0 to 4"}},
    {"empty", "[4.0, 2.1]", "[4.0, 1.2]", "17:8", {"from 1.2 to 1.2 along y", "from a lower to a higher"}},
    {"cut", "[4.0, 2.1]", "[4.0, 2.0]", "17:14", {"cuts cells of 0.3 along y at 2", "1.8 or 2.1"}},
    {"overlap", "[4.0, 1.2]", "[4.0, 1.5]", "19:1", {"overlaps the one before it of weight 0.5"}},
    {"twice", "weight = 4.0\n", "weight = 4.0\nweigth = 1.0\n", "23:1", {"did you mean 'weight'?"}},
    {"no_cells", "cells = [8, 10]\n", "", "23:1", {"[[source]]", "give 'method.cells'"}},
    {"dense", "\"dsmc\"", "\"dsmc-enskog\"", "23:1", {"'method.contact-factor' must be \"none\""}},
    {"contact_pairs",
     "cells = [8, 10]\n",
     "cells = [8, 10]\npair-count = \"expected\"\n",
     "26:14",
     {"\"counted\" or \"time-counter\""}},
    {"shifted",
     "cells = [8, 10]\n",
     "cells = [8, 10]\nlattice = \"shifted\"\n",
     "26:11",
     {"'method.lattice' must be \"fixed\" with a [[region]]"}},
    {"collisions",
     "duration = { time = 10.0 }",
     "duration = { collisions-per-particle = 10.0 }",
     "2:12",
     {"counts collisions of particles alike", "use a time or steps"}},
    {"step_of_collisions",
     "time-step = 0.1",
     "time-step = { collisions-per-particle = 0.1 }",
     "27:13",
     {"use a time or steps"}},
    {"equilibrate",
     "",
     "[initial]\nequilibrate-collisions-per-particle = 1.0\n",
     "32:39",
     {"particles alike", "remove it"}},
    {"source_over_border",
     "centre = [3.0, 0.5]",
     "centre = [2.0, 0.5]",
     "13:10",
     {"the source reaches over the border of a [[region]]"}},
    {"wall_force", "\"cloning\"", "\"wall-force\"", "29:8", {"'wall-force' counts simulated particles"}},
};

INSTANTIATE_TEST_SUITE_P(Region, RegionErrors, testing::ValuesIn(errors), edit_name);

/// Between walls nothing goes with them that counts pairs, planes or touches.
TEST(Regions, NeedAMethodThatKnowsThem) {
  for (const char* preset : {"event-driven", "collisionless", "mixing"}) {
    const std::string text = spoiled(good, {"", "\"dsmc\"", '"' + std::string(preset) + '"', "", {}});
    try {
      read_scene_text(text, "scene.toml");
      FAIL() << preset;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("'region' cannot be used with the method '" +
                                                   std::string(preset) + "', only with"));
    }
  }
}

TEST(Regions, AreObservedWhereThereAreSome) {
  expect_refused(R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [4.0, 3.0]
[[species]]
count = 100
diameter = 0.01
[method]
preset = "dsmc"
time-step = 0.1
)",
                 {"",
                  "",
                  "[[observe]]\nwhat = \"cloning\"\n",
                  "13:8",
                  {"the observer 'cloning' needs regions of other weights: give a table [[region]]"}});
}

}  // namespace
}  // namespace sandglass::rules_region_test
