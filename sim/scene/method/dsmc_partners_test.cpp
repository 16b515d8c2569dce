#include "sim/scene/method/capabilities.hpp"
#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::dsmc_partners_test {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
[[species]]
count = 100
[method]
preset = "esmc"
cells = [4, 7]
time-step = 0.1
[[observe]]
what = "energy"
every = { time = 1.0 }
)";

class PartnersScene : public testing::TestWithParam<BadEdit> {};

TEST_P(PartnersScene, RefusesWhatCannotBe) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> edits = {
    {"no_such_partner",
     "cells =",
     "partners = \"contacts\"\ncells =",
     "10:12",
     {"did you mean 'contact'", "'cell' or 'contact'"}},
    {"offset",
     "cells =",
     "offset = \"consistent\"\ncells =",
     "10:10",
     {"'method.offset' must be \"none\"", "partners = \"contact\"", "twice"}},
    {"expected_pairs", "cells =", "pair-count = \"expected\"\ncells =", "10:14", {"must be \"counted\""}},
    {"full_cells",
     "cells = [4, 7]",
     "excluded-volume = \"cells\"\ncells = [4, 6]",
     "10:19",
     {"must be \"none\""}},
    {"fitted_impact",
     "cells =",
     "impact = \"fitted\"\nimpact-coefficient = 0.4\ncells =",
     "10:10",
     {"must be \"uniform\"", "line of centres"}},
    {"offset_of_the_preset",
     "\"esmc\"",
     "\"cba\"\npartners = \"contact\"",
     "8:1",
     {"'method.offset' must be"}},
    {"narrow_cells",
     "[4, 7]",
     "[11, 7]",
     "10:9",
     {"0.9091 along axis 0", "at least a diameter (1)", "at most 10"}},
    {"narrow_size", "cells = [4, 7]", "cell-size = 0.9", "10:13", {"0.9", "at least a diameter (1)"}},
    {"narrow_box",
     "count = 100",
     "count = 100\ndiameter = 12.0",
     "5:8",
     {"an edge of 10", "at least a diameter (12)"}},
};

INSTANTIATE_TEST_SUITE_P(Edits, PartnersScene, testing::ValuesIn(edits), edit_name);

Scene with(const std::string& old, const std::string& now) {
  std::string text = good;
  text.replace(text.find(old), old.size(), now);
  return read_scene_text(text, "scene.toml");
}

/// What is written reads back as it was.
TEST(PartnersScene, KeepsItsKeyInTheRecord) {
  for (const Scene& scene : {with("\"esmc\"", "\"esmc\""), with("\"esmc\"", "\"esmc\"\npartners = \"cell\""),
                             with("\"esmc\"", "\"dsmc-enskog\"\npartners = \"contact\""),
                             with("\"esmc\"", "\"esmc\"\ncontact-factor = \"none\"")})
    EXPECT_EQ(read_scene_text(write_scene(scene), "again.toml"), scene);
}

/// The nearest number of cells, but none narrower than a diameter.
TEST(PartnersScene, KeepsCellsADiameterWide) {
  EXPECT_EQ(cells_along(with("cells = [4, 7]", "cell-size = 1.04")), (std::vector<double>{10, 19}));
  EXPECT_EQ(cells_along(with("\"esmc\"\ncells = [4, 7]", "\"cba\"\ncell-size = 0.6")),
            (std::vector<double>{17, 33}));
  EXPECT_EQ(cells_along(with("size = [10.0, 20.0]", "size = [10.9, 20.0]")), (std::vector<double>{4, 7}));
  const Scene scene = with("cells = [4, 7]", "cell-size = 1.9");
  EXPECT_EQ(cells_of_edge(scene, 0.1), (std::vector<double>{10, 20}));
}

TEST(PartnersScene, MissesPairsWhereCollisionsPushThemApart) {
  EXPECT_TRUE(loses_pairs(with("\"esmc\"", "\"esmc\"")));
  EXPECT_FALSE(loses_pairs(with("\"esmc\"", "\"dsmc-enskog\"")));
  EXPECT_TRUE(loses_pairs(with("\"esmc\"", "\"cba\"")));
  EXPECT_FALSE(loses_pairs(with("\"esmc\"", "\"cba-expected-pairs\"")));
}

}  // namespace
}  // namespace sandglass::dsmc_partners_test
