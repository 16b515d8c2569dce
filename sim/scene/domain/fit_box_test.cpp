#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::fit_box_test {
namespace {

const std::string boxless = R"([run]
seed = 1
duration = { steps = 1 }
[domain]
dimension = 2
proportions = [2.0, 1.0]
[[species]]
count = 400
area-fraction = 0.25
diameter = 2.0
[method]
preset = "dsmc"
time-step = 0.1
weight = 0.5
)";

TEST(FitBox, HoldsTheRealParticlesAtTheirFraction) {
  const Scene scene = read_scene_text(boxless, "scene.toml");
  EXPECT_NEAR(fraction(scene), 0.25, 1e-15);
  EXPECT_EQ(particle_count(scene), 400u);
  // 200 real disks of area pi at 0.25: 800 pi = 2 x 20 sqrt(pi) times 20 sqrt(pi).
  EXPECT_NEAR(scene.domain.size[1], 20 * std::sqrt(M_PI), 1e-12);
  EXPECT_NEAR(scene.domain.size[0], 40 * std::sqrt(M_PI), 1e-12);
}

TEST(FitBox, IsWrittenAsASize) {
  const Scene scene = read_scene_text(boxless, "scene.toml");
  EXPECT_EQ(read_scene_text(write_scene(scene), "again"), scene);
}

TEST(FitBox, IsACubeUnlessToldOtherwise) {
  const Scene scene = read_scene_text(spoiled(boxless, {"", "proportions = [2.0, 1.0]\n", "", "", {}}), "");
  EXPECT_EQ(scene.domain.size[0], scene.domain.size[1]);
  EXPECT_NEAR(fraction(scene), 0.25, 1e-15);
}

TEST(FitBox, ASizeLeavesNothingToFollow) {
  const std::string sized = spoiled(boxless, {"", "area-fraction = 0.25\n", "", "", {}});
  const std::string text = spoiled(sized, {"", "proportions = [2.0, 1.0]", "size = [90.0, 90.0]", "", {}});
  expect_refused(text, {"", "", "[domain.sides]\nz = 'periodic'\n", "15:1", {"axes x and y"}});
  expect_refused(text,
                 {"", "dimension = 2", "dimension = 2\nproportions = [1.0, 1.0]", "6:1", {"beside 'size'"}});
}

class FitBoxErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(FitBoxErrors, IsRefusedWithPlaceAndReason) { expect_refused(boxless, GetParam()); }

const std::vector<BadEdit> errors = {
    {"no_fraction", "area-fraction = 0.25\n", "", "4:1", {"missing 'domain.size'", "'count' beside"}},
    {"no_count", "count = 400\n", "", "4:1", {"missing 'domain.size'"}},
    {"two_measures",
     "[method]",
     "[[species]]\nname = 'b'\ncount = 3\narea-fraction = 0.1\n[method]",
     "14:17",
     {"two species give 'count' beside a fraction"}},
    {"no_proportion", "[2.0, 1.0]", "[2.0, 0.0]", "6:15", {"above 0 for each axis"}},
    {"proportions_of_3d", "[2.0, 1.0]", "[2.0, 1.0, 1.0]", "6:15", {"for each axis"}},
    {"bad_fraction", "0.25", "-0.25", "9:17", {"'species.area-fraction' is -0.25"}},
};

INSTANTIATE_TEST_SUITE_P(Box, FitBoxErrors, testing::ValuesIn(errors), edit_name);

}  // namespace
}  // namespace sandglass::fit_box_test
