#pragma once

#include <string>

// For the tests: a scene with everything that only the event-driven method knows.

namespace sandglass {

inline const std::string kDrivenDisks = R"([run]
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

}  // namespace sandglass
