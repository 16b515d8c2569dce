#pragma once

#include <vector>

namespace sandglass {

/// Centre of mass of 100 disks that collapse under gravity: diameter 0.001, box 0.02 by 0.04, mirrors, g = 9.81, start at
/// random without overlap, temperature 1e-4 of disks of mass 1. Event-driven with a contact time short enough not to
/// show: validation/case/granular-flow/collapse-under-gravity/README.md. Lengths, with the standard error of the mean of
/// the runs.
struct CollapsePoint {
  double time;
  double height;
  double standard_error;
};

/// For a restitution of 0.9 or 0.5. Throw InputError for another.
/// Until 0.05: height above the free fall of the run's own start.
const std::vector<CollapsePoint>& collapse_lift(double restitution);
/// From 0.1 on: height above the floor.
const std::vector<CollapsePoint>& collapse_height(double restitution);

}  // namespace sandglass
