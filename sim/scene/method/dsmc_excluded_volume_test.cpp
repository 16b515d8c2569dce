#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::dsmc_excluded_volume_test {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.y = "specular"
[[species]]
count = 10
[method]
preset = "hsmc"
cells = [4, 7]
time-step = { cell-fraction = 0.5 }
[[observe]]
what = "energy"
every = { time = 1.0 }
)";

class ExcludedVolumeScene : public testing::TestWithParam<BadEdit> {};

TEST_P(ExcludedVolumeScene, RefusesWhatCannotBe) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> edits = {
    {"no_room",
     "cells = [4, 7]",
     "weight = 100.0\ncells = [40, 70]",
     "12:9",
     {"room for", "at least 1", "'method.weight'"}},
    {"no_room_at_the_wall",
     "cells = [4, 7]",
     "weight = 5.0\nlattice = \"shifted\"\ncells = [4, 7]",
     "13:9",
     {"the smallest cell at a wall has room for 0.7", "'method.weight'"}},
    {"no_such_lattice",
     "cells =",
     "lattice = \"rotated\"\ncells =",
     "11:11",
     {"'rotated'", "'fixed', 'shifted' or 'diagonal'"}},
    {"too_dense", "cells =", "densest-fraction = 0.95\ncells =", "11:20", {"0.95", "close packing (0.9069)"}},
    {"nothing_to_fall",
     "cells =",
     "entry-probability = { fraction = [0.5, 0.8], probability = [1, 0] }\ncells =",
     "11:21",
     {"entry = \"falling\" only"}},
    {"empty_lists",
     "cells =",
     "entry = \"falling\"\nentry-probability = { fraction = [], probability = [] }\ncells =",
     "12:1",
     {"is empty", "leave it out"}},
    {"uneven_lists",
     "cells =",
     "entry = \"falling\"\nentry-probability = { fraction = [0.5, 0.8], probability = [1] }\ncells =",
     "12:21",
     {"2 numbers in 'fraction' and 1 in 'probability'"}},
    {"falling_fractions",
     "cells =",
     "entry = \"falling\"\nentry-probability = { fraction = [0.8, 0.5], probability = [1, 0] }\ncells =",
     "12:21",
     {"0.5 after 0.8", "must rise"}},
    {"unlikely",
     "cells =",
     "entry = \"falling\"\nentry-probability = { fraction = [0.5, 0.8], probability = [1.5, 0] }\ncells =",
     "12:61",
     {"1.5", "0 to 1"}},
    {"points_have_no_densest",
     "\"hsmc\"",
     "\"cba\"\ndensest-fraction = 0.8",
     "11:1",
     {"excluded-volume = \"cells\""}},
    {"steps_over_cells", "cell-fraction = 0.5", "cell-fraction = 1.5", "12:31", {"above 1"}},
    {"two_steps",
     "cell-fraction = 0.5",
     "cell-fraction = 0.5, collisions-per-particle = 0.1",
     "12:13",
     {"needs one of"}},
    {"no_coefficient", "\"hsmc\"", "\"hsmc-pb\"", "9:1", {"'method.impact-coefficient'", "a/(1 - c b^2)"}},
    {"grazing_only", "\"hsmc\"", "\"hsmc-pb\"\nimpact-coefficient = 1.0", "11:22", {"1", "-100 to 0.999"}},
    {"unused_coefficient", "cells =", "impact-coefficient = 0.3\ncells =", "11:1", {"impact = \"fitted\""}},
};

INSTANTIATE_TEST_SUITE_P(Edits, ExcludedVolumeScene, testing::ValuesIn(edits), edit_name);

/// A key that is missing because it is misspelt is among those that the misspelt one may have meant.
TEST(ExcludedVolumeScene, KnowsAMissingKeyByItsMisspelling) {
  const std::string text = spoiled(good, {"", "\"hsmc\"", "\"hsmc-pb\"\nimpact-coefficent = 0.4", "", {}});
  try {
    read_scene_text(text, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'impact-coefficient'?"));
  }
}

/// What is written reads back as it was.
TEST(ExcludedVolumeScene, KeepsItsKeysInTheRecord) {
  const auto with = [](const std::string& preset, const std::string& keys) {
    std::string text = good;
    text.replace(text.find("\"hsmc\""), 6, '"' + preset + "\"\n" + keys);
    return read_scene_text(text, "scene.toml");
  };
  for (const Scene& scene :
       {with("hsmc", "densest-fraction = 0.7"), with("hsmc-ramp", ""),
        with("hsmc-ramp", "entry-probability = { fraction = [0.5, 0.75], probability = [1, 0.25] }"),
        with("hsmc-pb", "impact-coefficient = 0.4"), with("hsmc-offset-everywhere", ""),
        with("hsmc-shift", ""), with("hsmc-rotated", ""), with("hsmc-shift", "lattice = \"fixed\""),
        with("dsmc", "lattice = \"diagonal\""),
        with("dsmc-pb", "impact-coefficient = { collisions-per-particle = [0, 80], value = [0, 0.5] }")})
    EXPECT_EQ(read_scene_text(write_scene(scene), "again.toml"), scene);
}

/// Cells on a corner are counted from corner to corner.
TEST(ExcludedVolumeScene, CountsDiagonalCellsFromCornerToCorner) {
  std::string text = good;
  text.replace(text.find("\"hsmc\""), 6, "\"hsmc-rotated\"");
  text.replace(text.find("cells = [4, 7]"), 14, "cells = [3, 7]");
  EXPECT_EQ(cells_along(read_scene_text(text, "scene.toml")), (std::vector<double>{3, 7}));
  text.replace(text.find("cells = [3, 7]"), 14, "cell-size = 2.0");
  EXPECT_EQ(cells_along(read_scene_text(text, "scene.toml")), (std::vector<double>{4, 7}));
}

TEST(ExcludedVolumeScene, RefusesDiagonalCellsIn3D) {
  std::string room = good;
  room.replace(room.find("dimension = 2\nsize = [10.0, 20.0]"), 33,
               "dimension = 3\nsize = [10.0, 20.0, 5.0]");
  room.replace(room.find("[4, 7]"), 6, "[4, 7, 2]");
  expect_refused(room,
                 {"", "\"hsmc\"", "\"hsmc-rotated\"", "9:1", {"in 2D only; use \"fixed\" or \"shifted\""}});
}

}  // namespace
}  // namespace sandglass::dsmc_excluded_volume_test
