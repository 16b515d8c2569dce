#pragma once

#include "sim/method/mixing/parameters.hpp"
#include "sim/scene/scene.hpp"

#include <string>

namespace sandglass::mixing {

/// Distance below which a step is too long for two particles of this mass together: where the stiffness of their
/// repulsion, omega^2 = mass |d/dr (r per_separation(r))|, has reached (2/dt)^2, the stability limit of the leapfrog
/// (Hockney & Eastwood 1981, section 4-4-2). 0: the step suits any distance.
double unstable_distance(const Repulsion& repulsion, double mass, double dt);

/// Relative speed far away with which two such particles reach that distance head-on.
double speed_to_reach(const Repulsion& repulsion, double mass, double distance);

/// Says when two of the heaviest particles start fast enough to reach that distance; empty if not.
std::string stability_warning(const Scene& scene, const Parameters& parameters);

}  // namespace sandglass::mixing
