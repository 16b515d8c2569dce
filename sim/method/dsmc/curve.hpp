#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sandglass::dsmc {

/// Numbers at rising places: straight lines in between, constant before the first and after the last.
struct Curve {
  std::vector<double> places, values;

  bool empty() const { return places.empty(); }
  /// Of a curve that is not empty.
  double at(double place) const {
    const auto above = std::upper_bound(places.begin(), places.end(), place);
    const auto i = static_cast<std::size_t>(above - places.begin());
    if (i == 0) return values.front();
    if (i == places.size()) return values.back();
    const double share = (place - places[i - 1]) / (places[i] - places[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  }
};

}  // namespace sandglass::dsmc
