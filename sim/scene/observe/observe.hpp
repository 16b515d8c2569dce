#pragma once

#include "sim/scene/run/cadence.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

struct Observe {
  std::string what;  ///< one of observer_kinds(), which also says what uses the values below
  Cadence cadence;
  std::optional<Cadence> start = {};           ///< no sample before so much time, steps or collisions
  int axis = 0;                                ///< of the component, or normal of the plane
  double position = 0;                         ///< crossings: where the plane stands on that axis
  std::optional<std::array<double, 2>> range;  ///< first and last bin edge
  std::uint64_t bins = 64;
  std::vector<std::uint64_t> grid;  ///< fields: bins per axis; structure-factor: lattice cells per axis
  bool operator==(const Observe&) const = default;
};

}  // namespace sandglass
