#pragma once

#include <string>
#include <vector>

namespace sandglass {

inline std::string axis_name(int axis) { return std::string(1, "xyz"[axis]); }

inline std::vector<std::string> axis_names(int dimension) {
  std::vector<std::string> names;
  for (int axis = 0; axis < dimension; ++axis) names.push_back(axis_name(axis));
  return names;
}

}  // namespace sandglass
