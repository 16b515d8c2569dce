#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace sandglass {

/// A place where particles appear during a run, floor(rate t) of them until time t.
struct Source {
  double rate = 0;                     ///< simulated particles per time
  std::optional<std::uint64_t> count;  ///< ends after so many; none: never
  std::optional<double> height;        ///< above the pile (sim/run/sources.hpp); none: `centre` says where
  std::vector<double> centre;          ///< of the region; with `height` without the component along gravity
  std::vector<double> width;           ///< of the region, as many components; empty: a point
  std::vector<double> velocity;        ///< empty: at rest
  bool operator==(const Source&) const = default;
};

}  // namespace sandglass
