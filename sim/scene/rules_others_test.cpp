#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_others_test {
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
preset = "dsmc"
time-step = 0.1
[initial]
exact = true
[[observe]]
what = "energy"
[output]
ids = false
)";

class OtherMethods : public testing::TestWithParam<BadEdit> {};

TEST_P(OtherMethods, RefuseWhatOnlyTheEventDrivenOneCanDo) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> other_edits = {
    {"guard",
     "time-step",
     "collapse-guard = \"none\"\ntime-step",
     "11:1",
     {"'method.collapse-guard' is for the method 'event-driven' only"}},
    {"contact_time",
     "time-step",
     "contact-time = 1.0\ntime-step",
     "11:1",
     {"'method.contact-time' is for the method 'event-driven' only"}},
    {"rough_wall",
     "[method]\npreset = \"dsmc\"",
     "[[wall]]\nside = \"y-low\"\ntangential-restitution = 0.5\n[method]\npreset = \"collisionless\"",
     "11:26",
     {"'wall.tangential-restitution' cannot be used with the method 'collisionless', only with 'dsmc'"}},
    {"no_atmosphere",
     "exact = true",
     "positions = \"barometric\"",
     "13:13",
     {"needs gravity along one axis"}},
    {"rough",
     "[method]\npreset = \"dsmc\"",
     "tangential-restitution = 0.5\n[method]\npreset = \"collisionless\"",
     "9:26",
     {"'species.tangential-restitution' cannot be used with the method 'collisionless', only with 'dsmc'"}},
    {"inertia",
     "count = 10",
     "count = 10\nmoment-of-inertia = 0.5",
     "9:21",
     {"'species.moment-of-inertia' needs rough contacts"}},
    {"two_species",
     "[method]\npreset = \"dsmc\"",
     "[[species]]\nname = \"b\"\ncount = 3\n[method]\npreset = \"collisionless\"",
     "9:1",
     {"more than one species cannot be used", "'event-driven'"}},
    {"one_species", "\"energy\"", "\"species\"", "15:8", {"the observer 'species' needs several species"}},
    {"trace",
     "ids = false",
     "event-trace = \"x\"",
     "17:15",
     {"'output.event-trace' cannot be used with the method 'dsmc', only with 'event-driven'"}},
    {"spin",
     "exact = true",
     "spin-temperature = 1.0",
     "13:20",
     {"'initial.spin-temperature' needs rough contacts"}},
    {"impact",
     "\"energy\"",
     "\"impact-parameter\"",
     "15:8",
     {"the observer 'impact-parameter' needs particles that touch: the method 'event-driven'"}},
    {"overlap",
     "\"energy\"",
     "\"overlap\"",
     "15:8",
     {"the observer 'overlap' needs particles that touch: the method 'event-driven'"}},
    {"rotation",
     "\"energy\"",
     "\"rotational-energy\"",
     "15:8",
     {"the observer 'rotational-energy' needs rough contacts"}},
    {"pair_walls",
     "\"energy\"",
     "\"pair-correlation\"\nrange = [0.0, 5.0]",
     "15:8",
     {"needs a domain that is periodic along every axis"}},
    {"structure",
     "\"energy\"",
     "\"structure-factor\"\ngrid = [4, 8]",
     "15:8",
     {"the observer 'structure-factor' needs a domain that is periodic"}},
    {"pair_velocity_walls",
     "\"energy\"",
     "\"pair-velocity\"\nrange = [0.0, 5.0]",
     "15:8",
     {"the observer 'pair-velocity' needs a domain that is periodic along every axis"}},
    {"surface_of_a_periodic_axis",
     "\"energy\"",
     "\"free-surface\"\ngrid = [1, 8]",
     "14:1",
     {"height along an axis that is not periodic", "give 'axis'"}},
    {"surface_with_two_heights",
     "\"energy\"",
     "\"free-surface\"\naxis = \"y\"\ngrid = [8, 4]",
     "17:8",
     {"'observe.grid' has 4 bins along y", "give 1 there"}},
    {"particles",
     "[method]",
     "[[particle]]\nposition = [5, 5]\nvelocity = [0, 0]\n[method]",
     "9:3",
     {"'particle' is used with positions = \"given\" in [initial] only"}},
};

INSTANTIATE_TEST_SUITE_P(Other, OtherMethods, testing::ValuesIn(other_edits), edit_name);

TEST(OtherMethodsTogether, LatticesKnowNoObstacles) {
  const std::string text = spoiled(good, {"", "exact = true", "positions = \"lattice\"", "", {}});
  expect_refused(text,
                 {"", "", "[[obstacle]]\ncentre = [5, 5]\nradius = 1", "13:13", {"inside the obstacles"}});
}

TEST(OtherMethodsTogether, ObserversOfStructureNeedTheirKeys) {
  const std::string text = spoiled(good, {"", "sides.y = \"specular\"\n", "", "", {}});
  expect_refused(text, {"", "\"energy\"", "\"pair-correlation\"", "13:1", {"missing 'observe.range'"}});
  expect_refused(text, {"", "\"energy\"", "\"structure-factor\"", "13:1", {"missing 'observe.grid'"}});
  expect_refused(text, {"", "\"energy\"", "\"pair-velocity\"", "13:1", {"missing 'observe.range'"}});
  expect_refused(text,
                 {"", "\"energy\"", "\"centre-of-mass\"", "14:8", {"needs an axis that is not periodic"}});
}

}  // namespace
}  // namespace sandglass::rules_others_test
