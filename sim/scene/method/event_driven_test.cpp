#include "sim/scene/test_bad_scene.hpp"
#include "sim/scene/test_driven_disks.hpp"

namespace sandglass::event_driven_test {
namespace {

class EventDriven : public testing::TestWithParam<BadEdit> {};

TEST_P(EventDriven, IsRefusedWithPlaceAndReason) { expect_refused(kDrivenDisks, GetParam()); }

const std::vector<BadEdit> method_edits = {
    {"contact_factor",
     "time-step",
     "contact-factor = \"none\"\ntime-step",
     "34:1",
     {"is not used by the method 'event-driven', whose collisions are exact"}},
    {"density", "time-step", "density = \"smoothed\"\ntime-step", "34:1", {"'method.density' is not used"}},
    {"offset", "time-step", "offset = \"none\"\ntime-step", "34:1", {"'method.offset' is not used"}},
    {"random_offset",
     "time-step",
     "random-offset = 0.5\ntime-step",
     "34:1",
     {"'method.random-offset' is not used"}},
    {"cells",
     "time-step",
     "cells = [2, 4]\ntime-step",
     "34:1",
     {"is chosen by the method 'event-driven' itself"}},
    {"cell_size",
     "time-step",
     "cell-size = 2.0\ntime-step",
     "34:1",
     {"'method.cell-size' is chosen by the method"}},
    {"weight", "time-step", "weight = 2.0\ntime-step", "34:10", {"'method.weight'", "it must be 1"}},
    {"no_time_step", "time-step = 0.1\n", "", "30:1", {"missing 'method.time-step'"}},
    {"guard_word",
     "\"contact-time\"",
     "\"contact\"",
     "32:18",
     {"unknown collapse guard 'contact'", "'velocity-dependent'"}},
    {"guard_number", "contact-time = 1e-5\n", "", "30:1", {"missing 'method.contact-time'"}},
    {"guard_zero", "1e-5", "0.0", "33:16", {"'method.contact-time' is 0; allowed: above 0"}},
    {"guard_none",
     "\"contact-time\"",
     "\"none\"",
     "33:1",
     {"'method.contact-time' is used with collapse-guard = \"contact-time\" only",
      "the guard here is \"none\""}},
    {"guard_other",
     "contact-time = 1e-5",
     "contact-time = 1e-5\nreference-speed = 1.0",
     "34:1",
     {"'method.reference-speed' is used with collapse-guard = \"velocity-dependent\" only"}},
    {"guard_speed",
     "\"contact-time\"\ncontact-time = 1e-5",
     "\"velocity-dependent\"\nreference-speed = -1.0",
     "33:19",
     {"'method.reference-speed' is -1; allowed: above 0"}},
    {"random_positions",
     "\"lattice\"",
     "\"random\"",
     "36:13",
     {"lets hard particles overlap", "\"lattice\" or \"random-without-overlap\""}},
    {"default_positions", "positions = \"lattice\"\n", "", "35:1", {"positions = \"random\" (the default)"}},
    {"spin_temperature",
     "= 0.5\n[[observe]]",
     "= -0.5\n[[observe]]",
     "37:20",
     {"'initial.spin-temperature' is -0.5; allowed: 0 or more"}},
    {"empty_trace", "\"events.csv\"", "\"\"", "42:15", {"'output.event-trace' is empty; name a file"}},
};

const std::vector<BadEdit> species_edits = {
    {"tangential_low",
     "tangential-restitution = 0.5",
     "tangential-restitution = -1.5",
     "10:26",
     {"'species.tangential-restitution' is -1.5; allowed: -1 to 1"}},
    {"friction",
     "friction = 0.2",
     "friction = -0.2",
     "11:12",
     {"'species.friction' is -0.2; allowed: 0 or more"}},
    {"friction_smooth",
     "diameter = 2.0",
     "diameter = 2.0\nfriction = 0.2",
     "17:12",
     {"'species.friction' needs 'tangential-restitution' above -1"}},
    {"no_inertia",
     "moment-of-inertia = 0.5",
     "moment-of-inertia = 0",
     "12:21",
     {"'species.moment-of-inertia' is 0; allowed: above 0, to 1"}},
    {"much_inertia",
     "moment-of-inertia = 0.5",
     "moment-of-inertia = 1.1",
     "12:21",
     {"is 1.1; allowed: 0 to 1"}},
    {"same_name", "\"large\"", "\"small\"", "13:1", {"two species are called 'small'"}},
    {"none_of_one",
     "count = 10",
     "count = 0",
     "9:9",
     {"'species.count' gives 0 particles; each species needs at least 1"}},
    {"none_of_other",
     "= 0.025",
     "= 0.001",
     "15:18",
     {"'species.number-density' gives 0 particles; each species needs at least 1"}},
    {"dense_together", "= 0.025", "= 0.28", "9:9", {"gives the area fraction 0.9189 of all species"}},
    {"many",
     "= 0.025",
     "= 1e12",
     "9:9",
     {"gives 200000000000010 particles with the other species; at most 1"}},
};

INSTANTIATE_TEST_SUITE_P(Method, EventDriven, testing::ValuesIn(method_edits), edit_name);
INSTANTIATE_TEST_SUITE_P(Species, EventDriven, testing::ValuesIn(species_edits), edit_name);

TEST(EventDrivenTogether, ReadsWhatItIsGiven) {
  const Scene scene = read_scene_text(kDrivenDisks, "");
  EXPECT_EQ(method_family(scene), "event-driven");
  EXPECT_TRUE(is_rough(scene));
  EXPECT_EQ(particle_count(scene), 15U);
  EXPECT_EQ(scene.species[0].friction, 0.2);
  EXPECT_EQ(scene.species[0].inertia_factor, 0.5);
  EXPECT_FALSE(scene.species[1].friction.has_value());
  ASSERT_EQ(scene.walls.size(), 2U);
  EXPECT_EQ(scene.walls[0], (Wall{1, false, {SurfaceKind::specular, 0.8}, {}, 0.5, 2}));
  EXPECT_EQ(scene.walls[1], (Wall{1, true, {SurfaceKind::thermal, 1, -1, {}, 1, 2}, {1, 0}}));
  ASSERT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(scene.obstacles[0], (Obstacle{{5, 10}, 1, {}}));
  EXPECT_EQ(guard_of(scene.method), (Guard{CollapseGuard::contact_time, 1e-5, 0}));
  EXPECT_EQ(scene.initial.spin_temperature, 0.5);
  EXPECT_EQ(scene.output.event_trace, "events.csv");
}

TEST(EventDrivenTogether, PairCorrelationReachesHalfTheShortestEdge) {
  const std::string observer = "\"pair-correlation\"\nrange = [0.0, 5.0]\nbins = 20";
  const std::string walls = kDrivenDisks.substr(
      kDrivenDisks.find("[[wall]]"), kDrivenDisks.find("[method]") - kDrivenDisks.find("[[wall]]"));
  std::string text = spoiled(kDrivenDisks, {"", walls, "", "", {}});
  text = spoiled(text, {"", "sides.y = \"specular\"\n", "", "", {}});
  text = spoiled(text, {"", "\"impact-parameter\"\nbins = 20", observer, "", {}});
  expect_refused(text, {"", "[0.0, 5.0]", "[0.0, 5.1]", "26:9", {"from 0 to half the shortest edge, 5"}});
  expect_refused(text, {"", "[0.0, 5.0]", "[-0.1, 5.0]", "26:9", {"goes from -0.1 to 5"}});
}

}  // namespace
}  // namespace sandglass::event_driven_test
