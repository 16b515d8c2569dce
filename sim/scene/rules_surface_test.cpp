#include "sim/scene/fault_table.hpp"

namespace sandglass {
namespace {

const std::string good = R"([run]
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 20.0]
sides.y = "specular"
[[species]]
name = "small"
count = 10
tangential-restitution = 0.5
friction = 0.2
moment-of-inertia = 0.5
[[species]]
name = "large"
number-density = 0.025
diameter = 2.0
[[wall]]
side = "y-low"
restitution = 0.8
amplitude = 0.5
frequency = 2.0
[[wall]]
side = "y-high"
rule = "thermal"
temperature = 2.0
velocity = [1.0, 0.0]
[[obstacle]]
centre = [5.0, 10.0]
radius = 1.0
[method]
preset = "event-driven"
collapse-guard = "contact-time"
contact-time = 1e-5
time-step = 0.1
[initial]
positions = "lattice"
spin-temperature = 0.5
[[observe]]
what = "impact-parameter"
bins = 20
[output]
event-trace = "events.csv"
)";

class Surfaces : public testing::TestWithParam<Fault> {};

TEST_P(Surfaces, AreRefusedWithPlaceAndReason) { expect_fault(good, GetParam()); }

const std::vector<Fault> surface_faults = {
    {"side", "\"y-low\"", "\"bottom\"", "18:8", {"unknown side of the domain 'bottom'", "'y-low'"}},
    {"no_side", "side = \"y-low\"\n", "", "17:1", {"missing 'wall.side'", "'z-high'"}},
    {"side_of_3d", "\"y-low\"", "\"z-low\"", "18:8", {"'wall.side' is 'z-low'", "has the axes x and y"}},
    {"periodic_side", "\"y-low\"", "\"x-low\"", "18:8", {"x is periodic", "[domain.sides] x = \"specular\""}},
    {"same_side", "\"y-high\"", "\"y-low\"", "22:1", {"two tables [[wall]] speak of 'y-low'"}},
    {"rule", "\"thermal\"", "\"termal\"", "24:8", {"unknown wall rule 'termal'; did you mean 'thermal'?"}},
    {"wall_restitution", "= 0.8", "= 1.8", "19:15", {"'wall.restitution' is 1.8; allowed: 0 to 1"}},
    {"thermal_restitution",
     "temperature = 2.0",
     "temperature = 2.0\nrestitution = 0.5",
     "26:1",
     {"'wall.restitution' is used with rule = 'specular', 'bounce-back' or 'random-tangential-sign' only; "
      "the rule here is 'thermal'"}},
    {"thermal_rough",
     "temperature = 2.0",
     "temperature = 2.0\ntangential-restitution = 0.5",
     "26:1",
     {"with rule = 'specular' only"}},
    {"cold", "temperature = 2.0\n", "", "22:1", {"missing 'wall.temperature'"}},
    {"frozen",
     "temperature = 2.0",
     "temperature = 0.0",
     "25:15",
     {"'wall.temperature' is 0; allowed: above 0"}},
    {"warm_mirror",
     "= 0.8",
     "= 0.8\ntemperature = 1.0",
     "20:1",
     {"'wall.temperature' is used with rule = 'thermal' only"}},
    {"probability",
     "= 0.8",
     "= 0.8\nprobability = 1.0",
     "20:1",
     {"with rule = 'bounce-back' only; the rule here is 'specular'"}},
    {"bounce_probability",
     "\"thermal\"\ntemperature = 2.0",
     "\"bounce-back\"\nprobability = 1.5",
     "25:15",
     {"'wall.probability' is 1.5; allowed: 0 to 1"}},
    {"wall_friction",
     "= 0.8",
     "= 0.8\nfriction = 0.5",
     "20:12",
     {"'wall.friction' needs 'tangential-restitution' above -1"}},
    {"velocity_of_3d", "[1.0, 0.0]", "[1.0, 0.0, 0.0]", "26:12", {"'wall.velocity' has 3 components"}},
    {"no_frequency", "frequency = 2.0\n", "", "17:1", {"missing 'wall.frequency'"}},
    {"no_amplitude", "amplitude = 0.5\n", "", "20:1", {"'wall.frequency' is given without 'amplitude'"}},
    {"negative_amplitude",
     "amplitude = 0.5",
     "amplitude = -0.5",
     "20:13",
     {"'wall.amplitude' is -0.5; allowed: above 0"}},
    {"zero_frequency",
     "frequency = 2.0",
     "frequency = 0.0",
     "21:13",
     {"'wall.frequency' is 0; allowed: above 0"}},
    {"moved_twice",
     "frequency = 2.0",
     "frequency = 2.0\nvelocity = [0.0, 0.1]",
     "22:12",
     {"'wall.velocity' moves the plane that 'amplitude'"}},
    {"no_room",
     "amplitude = 0.5",
     "amplitude = 18.5",
     "20:13",
     {"walls along y swing by 18.5", "no room for a particle of diameter 2 in 20"}},
    {"unknown_key",
     "amplitude = 0.5",
     "ampltude = 0.5\namplitude = 0.5",
     "20:1",
     {"did you mean 'amplitude'?"}},
    {"no_centre", "centre = [5.0, 10.0]\n", "", "27:1", {"missing 'obstacle.centre'"}},
    {"no_radius", "radius = 1.0\n", "", "27:1", {"missing 'obstacle.radius'"}},
    {"radius", "radius = 1.0", "radius = 0", "29:10", {"'obstacle.radius' is 0; allowed: above 0"}},
    {"on_seam",
     "[5.0, 10.0]",
     "[2.9, 10.0]",
     "28:11",
     {"'obstacle.centre' is 2.9 along x", "allowed: 3 to 7"}},
    {"on_wall",
     "[5.0, 10.0]",
     "[5.0, 17.1]",
     "28:16",
     {"'obstacle.centre' is 17.1 along y", "allowed: 3 to 17"}},
    {"centre_of_3d", "[5.0, 10.0]", "[5.0, 10.0, 5.0]", "28:10", {"'obstacle.centre' has 3 components"}},
    {"moving_obstacle",
     "radius = 1.0",
     "radius = 1.0\nvelocity = [1.0, 0.0]",
     "30:1",
     {"an obstacle stands still; remove it"}},
};

INSTANTIATE_TEST_SUITE_P(Surface, Surfaces, testing::ValuesIn(surface_faults), fault_name);

}  // namespace
}  // namespace sandglass
