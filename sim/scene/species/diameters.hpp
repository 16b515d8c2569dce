#pragma once

#include "sim/scene/text/table.hpp"

#include <vector>

namespace sandglass {

/// Diameters that stand for a distribution, and the share of the particles that each has; shares add up to one.
struct Diameters {
  std::vector<double> values, shares;

  double mean() const;
};

/// A distribution cut into `classes` of equal probability, each with the diameter at its middle (quantiles 1/2n, 3/2n, ...).
Diameters uniform_diameters(double low, double high, std::size_t classes);
Diameters normal_diameters(double mean, double deviation, std::size_t classes);
/// Of the diameters themselves, not of their logarithms.
Diameters lognormal_diameters(double mean, double deviation, std::size_t classes);

/// The table `diameter = { distribution = ..., ... }` of a species; reports what is wrong in it and returns nothing then.
std::optional<Diameters> read_diameters(Table& species);

}  // namespace sandglass
