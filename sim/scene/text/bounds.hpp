#pragma once

#include "sim/scene/text/diagnostics.hpp"

#include <limits>
#include <string>
#include <vector>

namespace sandglass {

/// An interval of allowed numbers and how a message words it.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_allowed = true;
  std::string text = "a finite number";

  /// False for NaN and infinity, whatever the bounds.
  bool hold(double value) const;
};

Bounds finite();
Bounds positive();
Bounds at_least(double low);
Bounds between(double low, double high);
/// Of a length, a mass or a weight: products and quotients of several of them are finite and not zero.
Bounds moderate();
/// Of a velocity: sums of its squares are finite.
Bounds speed();

/// Reports the value at `path` when it is out of bounds; true when it is within.
bool check_bounds(Diagnostics& diagnostics, const std::string& path, double value, const Bounds& bounds);

/// Reports a vector that has not one component per axis; true when it has.
bool check_length(Diagnostics& diagnostics, const std::string& path, std::size_t length, int dimension);
/// As many components as dimensions, each within the bounds; false also where the value had an error already.
bool check_vector(Diagnostics& diagnostics, const std::string& path, const std::vector<double>& values,
                  int dimension, const Bounds& bounds);

}  // namespace sandglass
