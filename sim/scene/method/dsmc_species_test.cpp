#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::dsmc_species_test {
namespace {

const std::string mixture = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [20.0, 40.0]
[[species]]
name = "small"
count = 100
[[species]]
name = "large"
count = 100
diameter = 2.0
[method]
preset = "dsmc"
time-step = 0.1
[[observe]]
what = "species"
every = { time = 1.0 }
)";

class Mixture : public testing::TestWithParam<BadEdit> {};

TEST_P(Mixture, RefusesWhatCannotBe) { expect_refused(mixture, GetParam()); }

const std::vector<BadEdit> mixture_edits = {
    {"full_cells",
     "time-step",
     "excluded-volume = \"cells\"\ntime-step",
     "15:19",
     {"how the species part", "'event-driven'"}},
    {"fitted",
     "time-step",
     "impact = \"fitted\"\nimpact-coefficient = 0.1\ntime-step",
     "15:10",
     {"smooth particles of one species"}},
    {"barometric",
     "[[observe]]",
     "[initial]\npositions = \"barometric\"\n[[observe]]",
     "17:13",
     {"positions"}},
};

INSTANTIATE_TEST_SUITE_P(Edits, Mixture, testing::ValuesIn(mixture_edits), edit_name);

TEST(Mixture, IsTaken) {
  for (const char* preset :
       {"dsmc", "dsmc-bird", "dsmc-enskog", "cba", "cba-corrected", "cuba", "cba-expected-pairs", "esmc"}) {
    std::string text = mixture;
    text.replace(text.find("\"dsmc\""), 6, '"' + std::string(preset) + '"');
    EXPECT_EQ(read_scene_text(text, "scene.toml").species.size(), 2u) << preset;
  }
}

TEST(TimeCounter, NeedsCellsThatStay) {
  const BadEdit edit{"shifted",
                     "preset = \"dsmc\"",
                     "preset = \"dsmc-bird\"\nlattice = \"shifted\"",
                     "13:1",
                     {"must not be \"time-counter\" with lattice = \"shifted\""}};
  expect_refused(mixture, edit);
}

TEST(RoughParticles, GoWithContactValueAndOffset) {
  std::string rough = mixture;
  const auto second = rough.find("[[species]]\nname = \"large\""), end = rough.find("[method]");
  rough.replace(second, end - second, "tangential-restitution = 0.0\n");
  rough.replace(rough.find("\"species\""), 9, "\"rotational-energy\"");
  for (const char* preset : {"dsmc", "dsmc-enskog", "cba", "cba-expected-pairs", "hsmc"}) {
    std::string text = rough;
    text.replace(text.find("\"dsmc\""), 6, '"' + std::string(preset) + '"');
    EXPECT_NO_THROW(read_scene_text(text, "scene.toml")) << preset;
  }
  rough.replace(rough.find("\"dsmc\""), 6, "\"esmc\"");
  EXPECT_THROW(read_scene_text(rough, "scene.toml"), InputError);
}

}  // namespace
}  // namespace sandglass::dsmc_species_test
