#pragma once

#include "sim/scene/method/options.hpp"

#include <string>

namespace sandglass {

/// Time step: fixed, or chosen so that a particle collides `collisions` times per step (Galilean invariant), or so that
/// no pair comes closer by more than `cell_fraction` of a cell in a step. Exactly one of them.
struct TimeStep {
  std::optional<double> fixed;
  std::optional<double> collisions = {};
  std::optional<double> cell_fraction = {};
  bool operator==(const TimeStep&) const = default;
};

struct Method {
  std::string preset = "dsmc";  ///< one of preset_names(); choose() keeps it and `options` together
  TimeStep time_step;
  double weight = 1;  ///< real particles per simulated one (F_N of the DSMC literature)
  MethodOptions options;
  bool operator==(const Method&) const = default;
};

/// The choices that a preset stands for, made in a method. Throws InputError for a name that is not known.
void choose(Method& method, const std::string& preset);

/// The collapse guard; of a family that has none, the guard `none`.
Guard guard_of(const Method& method);

}  // namespace sandglass
