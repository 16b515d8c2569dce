#include "sim/scene/test_bad_scene.hpp"

// Gravity along a periodic axis: what particles gain in the fall must go somewhere.

namespace sandglass::rules_gravity_test {
namespace {

const std::string pipe = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [10.0, 80.0]
sides.x = "specular"
[[species]]
count = 100
restitution = 0.9
[[wall]]
side = "x-low"
rule = "bounce-back"
probability = 0.5
[method]
preset = "dsmc"
time-step = 0.1
[forces]
gravity = [0.0, -1.0]
)";

const std::string no_momentum = "gain momentum without bound";
const std::string no_energy = "gain energy without bound";

class EndlessFall : public testing::TestWithParam<BadEdit> {};

TEST_P(EndlessFall, IsRefusedWithPlaceAndReason) { expect_refused(pipe, GetParam()); }

const std::vector<BadEdit> errors = {
    {"smooth_walls",
     "rule = \"bounce-back\"\nprobability = 0.5\n",
     "",
     "16:17",
     {"periodic axis y", no_momentum, "\"bounce-back\""}},
    {"never_bouncing", "probability = 0.5", "probability = 0.0", "18:17", {no_momentum}},
    {"open_pipe",
     "[[wall]]\nside = \"x-low\"\nrule = \"bounce-back\"\nprobability = 0.5\n",
     "",
     "14:17",
     {no_momentum, "y = \"specular\""}},
    {"elastic",
     "restitution = 0.9\n",
     "",
     "17:17",
     {no_energy, "lower a 'restitution' below 1", "\"thermal\""}},
    {"no_collisions",
     "\"dsmc\"",
     "\"collisionless\"",
     "18:17",
     {no_energy, "without collisions between particles use a wall"}},
};

INSTANTIATE_TEST_SUITE_P(Gravity, EndlessFall, testing::ValuesIn(errors), edit_name);

TEST(EndlessFall, EndsAtWhateverTakesMomentumAndEnergy) {
  const auto accepted = [](const std::string& find, const std::string& replace) {
    EXPECT_NO_THROW(read_scene_text(spoiled(pipe, {"", find, replace, "", {}}), "scene.toml")) << replace;
  };
  const std::string rule = "rule = \"bounce-back\"\nprobability = 0.5";
  accepted(rule, "rule = \"random-tangential-sign\"");
  accepted("restitution = 0.9",
           "restitution = 1.0\n[[obstacle]]\ncentre = [5.0, 5.0]\nradius = 1.0\nrestitution = 0.5");
  accepted("restitution = 0.9\n[[wall]]\nside = \"x-low\"\n" + rule,
           "[[wall]]\nside = \"x-low\"\nrule = \"thermal\"\ntemperature = 1.0");
  accepted("[method]\npreset = \"dsmc\"",
           "[initial]\npositions = \"lattice\"\n[method]\npreset = \"event-driven\"");
}

}  // namespace
}  // namespace sandglass::rules_gravity_test
