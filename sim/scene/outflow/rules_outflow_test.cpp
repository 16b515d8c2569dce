#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::rules_outflow_test {
namespace {

const std::string good = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [60.0, 20.0]
sides.x = "open"
[[species]]
area-fraction = 0.5
[[obstacle]]
centre = [30.0, 10.0]
radius = 4.0
[[inflow]]
side = "x-low"
entry = "dispenser"
piston = "thermal"
number-density = 0.6366
velocity = [0.2, 0.0]
temperature = 1.0
[[outflow]]
side = "x-high"
velocity = [0.2, 0.0]
temperature = 1.0
filter = 3.0
[method]
preset = "event-driven"
time-step = 0.1
[initial]
positions = "lattice"
)";

TEST(Outflows, AreReadAndWritten) {
  const Scene scene = read_scene_text(good, "scene.toml");
  ASSERT_EQ(scene.outflows.size(), 1u);
  EXPECT_EQ(scene.outflows[0], (Outflow{0, true, {0.2, 0}, 1, 3}));
  EXPECT_EQ(scene.inflows[0].entry, InflowEntry::dispenser);
  EXPECT_EQ(scene.inflows[0].piston, Piston::thermal);
  EXPECT_EQ(read_scene_text(write_scene(scene), "again"), scene);
  EXPECT_EQ(layer_count(scene, scene.inflows[0]), 13);
  EXPECT_DOUBLE_EQ(inflow_rate(scene, scene.inflows[0]), 0.6366 * 0.2 * 20);
}

TEST(Outflows, AStreamAtRestIsALimitThatRuns) {
  std::string text = good;
  for (std::size_t at; (at = text.find("velocity = [0.2, 0.0]\n")) != std::string::npos;) text.erase(at, 22);
  EXPECT_NO_THROW(read_scene_text(text, "rest.toml"));
}

class OutflowErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(OutflowErrors, AreRefusedWithPlaceAndReason) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> errors = {
    {"side",
     "\"x-high\"",
     "\"y-high\"",
     "20:8",
     {"'outflow.side' is 'y-high', which is periodic", "goes out by"}},
    {"cold", "temperature = 1.0\nfilter", "temperature = 0.0\nfilter", "22:15", {"is 0; allowed: above 0"}},
    {"inwards",
     "[0.2, 0.0]\ntemperature = 1.0\nfilter",
     "[-0.2, 0.0]\ntemperature = 1.0\nfilter",
     "21:12",
     {"comes in by 'x-high' at a speed of 0.2", "use [[inflow]]"}},
    {"aslant",
     "[0.2, 0.0]\ntemperature = 1.0\nfilter",
     "[0.2, 0.1]\ntemperature = 1.0\nfilter",
     "21:12",
     {"no other component"}},
    {"slower_than_the_piston",
     "[0.2, 0.0]\ntemperature = 1.0\nfilter",
     "[0.1, 0.0]\ntemperature = 1.0\nfilter",
     "21:12",
     {"pushes the stream in at a speed of 0.2", "leaves at 0.1"}},
    {"source_behind_the_piston",
     "filter = 3.0\n[method]",
     "[[source]]\nrate = 1.0\ncentre = [30.0, 3.0]\n[method]",
     "14:9",
     {"could appear behind the piston"}},
    {"shallow",
     "filter = 3.0",
     "filter = 0.5",
     "23:10",
     {"is 0.5; allowed: from a diameter to half the box, 1 to 30"}},
    {"fall",
     "[initial]",
     "[forces]\ngravity = [0.1, 0.0]\n[initial]",
     "23:10",
     {"cannot fall: remove 'forces.gravity'"}},
    {"in_the_filter",
     "filter = 3.0",
     "filter = 26.0",
     "23:10",
     {"an obstacle of radius 4 stands 26 from 'x-high'"}},
    {"twice",
     "[method]",
     "[[outflow]]\nside = 'x-high'\ntemperature = 1.0\n[method]",
     "25:8",
     {"two tables [[outflow]] name 'x-high'"}},
    {"both",
     "[method]",
     "[[inflow]]\nside = 'x-high'\nnumber-density = 0.1\ntemperature = 1.0\n[method]",
     "20:8",
     {"an [[inflow]] comes in by 'x-high' too"}},
    {"unknown", "filter = 3.0", "fliter = 3.0", "23:1", {"did you mean 'filter'?"}},
    {"entry",
     "\"dispenser\"",
     "\"dispencer\"",
     "14:9",
     {"unknown way to enter", "did you mean 'dispenser'?"}},
    {"arrivals", "piston = \"thermal\"", "arrivals = \"even\"", "15:1", {"with entry = \"flux\" only"}},
    {"dense",
     "= 0.6366",
     "= 1.02",
     "16:18",
     {"a layer of 21 particles of diameter 1 does not fit a side of 20", "to 1,"}},
    {"against",
     "[0.2, 0.0]\ntemperature = 1.0\n[[outflow]]",
     "[-0.2, 0.0]\ntemperature = 1.0\n[[outflow]]",
     "17:12",
     {"a piston moves into the box or stands still"}},
    {"beside_an_obstacle", "= 0.6366", "= 0.00196", "13:8", {"an obstacle stands 26 from 'x-low'"}},
};

INSTANTIATE_TEST_SUITE_P(Outflow, OutflowErrors, testing::ValuesIn(errors), edit_name);

/// DSMC has no surface to push with, and nothing that it turns back.
TEST(Outflows, NeedTheMethodThatHasThem) {
  const std::string points = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [60.0, 20.0]
sides.x = "open"
[[species]]
area-fraction = 0.5
[method]
preset = "dsmc"
cell-size = 2.0
time-step = 0.1
)";
  expect_refused(points, {"",
                          "",
                          "[[outflow]]\nside = 'x-high'\ntemperature = 1.0\n",
                          "13:1",
                          {"'outflow' cannot be used with the method 'dsmc', only with 'event-driven'",
                           "an [[inflow]] at that side"}});
  expect_refused(
      points, {"",
               "",
               "[[inflow]]\nside = 'x-low'\nentry = 'dispenser'\nnumber-density = 0.6\ntemperature = 1.0\n",
               "15:9",
               {"a dispenser makes room for particles with a surface: use the method 'event-driven'"}});
}

}  // namespace
}  // namespace sandglass::rules_outflow_test
