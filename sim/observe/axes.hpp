#pragma once

#include <string>
#include <vector>

namespace sandglass {

inline std::string axis_name(int axis) { return std::string(1, "xyz"[axis]); }

/// "x-low", "x-high", ...
inline std::string side_name(int axis, bool high) { return axis_name(axis) + (high ? "-high" : "-low"); }

inline std::vector<std::string> axis_names(int dimension) {
  std::vector<std::string> names;
  for (int axis = 0; axis < dimension; ++axis) names.push_back(axis_name(axis));
  return names;
}

}  // namespace sandglass
