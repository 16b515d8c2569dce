#pragma once

#include "sim/scene/run/cadence.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace sandglass {

/// Exactly one is given. `collisions` counts collisions per particle, 2 C / N.
struct Duration {
  std::optional<double> time;
  std::optional<std::uint64_t> steps;
  std::optional<double> collisions;
  bool operator==(const Duration&) const = default;
};

struct Output {
  std::string record;  ///< path of the record; empty: scene's name with .h5, in the working folder
  std::optional<Cadence> trajectory;  ///< frames of positions and velocities (first replica)
  bool ids = false;                   ///< keep particle identities (costs 8 bytes a particle)
  std::optional<Cadence> checkpoint;
  std::optional<std::string> event_trace;  ///< file with a line per event (event-driven, first replica)
  bool operator==(const Output&) const = default;
};

struct Run {
  std::uint64_t seed = 1;
  std::uint64_t replicas = 1;
  Duration duration;
  bool operator==(const Run&) const = default;
};

}  // namespace sandglass
