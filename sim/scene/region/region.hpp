#pragma once

#include <vector>

namespace sandglass {

/// A box of the domain in which a simulated particle stands for another number of real ones.
struct Region {
  std::vector<double> low, high;  ///< corners
  double weight = 1;              ///< real particles per simulated one, instead of Method::weight
  bool operator==(const Region&) const = default;
};

}  // namespace sandglass
