#pragma once

#include <optional>
#include <vector>

namespace sandglass {

/// An open side beyond which the stream goes on: of those who come to it as many are turned back as the gas beyond would
/// send in for them (Baryshev 2003, 3.3).
struct Outflow {
  int axis = 0;
  bool high = false;
  std::vector<double> velocity;  ///< of the stream; empty: at rest
  double temperature = 0;        ///< about it
  /// From the side: where those who are not turned back become heavy and move with the stream. None: they leave.
  std::optional<double> filter;
  bool operator==(const Outflow&) const = default;
};

}  // namespace sandglass
