#include "sim/scene/text/bounds.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

bool Bounds::hold(double value) const {
  return std::isfinite(value) && value <= high && (value > low || (low_allowed && value == low));
}

Bounds finite() { return {}; }

Bounds positive() {
  Bounds bounds;
  bounds.low = 0;
  bounds.low_allowed = false;
  bounds.text = "above 0";
  return bounds;
}

Bounds at_least(double low) {
  Bounds bounds;
  bounds.low = low;
  bounds.text = fmt::format("{} or more", low);
  return bounds;
}

Bounds between(double low, double high) {
  Bounds bounds = at_least(low);
  bounds.high = high;
  bounds.text = fmt::format("{} to {}", low, high);
  return bounds;
}

Bounds moderate() {
  Bounds bounds = between(1e-100, 1e100);
  bounds.text = "above 0, " + bounds.text;
  return bounds;
}

Bounds speed() {
  constexpr double most = 1e100;
  return between(-most, most);
}

bool check_bounds(Diagnostics& diagnostics, const std::string& path, double value, const Bounds& bounds) {
  if (bounds.hold(value)) return true;
  diagnostics.report(path, fmt::format("{} is {}; allowed: {}", shown(path), value, bounds.text));
  return false;
}

bool check_length(Diagnostics& diagnostics, const std::string& path, std::size_t length, int dimension) {
  if (length == static_cast<std::size_t>(dimension)) return true;
  diagnostics.report(path, fmt::format("{} has {} component{}, but the scene has {} dimensions: give {}",
                                       shown(path), length, length == 1 ? "" : "s", dimension, dimension));
  return false;
}

bool check_vector(Diagnostics& diagnostics, const std::string& path, const std::vector<double>& values,
                  int dimension, const Bounds& bounds) {
  if (!diagnostics.clean(path)) return false;
  bool good = check_length(diagnostics, path, values.size(), dimension);
  for (std::size_t axis = 0; axis < values.size(); ++axis)
    good &= check_bounds(diagnostics, item_path(path, axis), values[axis], bounds);
  return good;
}

}  // namespace sandglass
