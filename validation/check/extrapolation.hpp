#pragma once

#include <vector>

namespace sandglass {

/// Weights w with which sum w_i y_i is the value at x = 0 of the polynomial of least squares through (x_i, y_i), all of
/// equal weight. `x` of order one, more points than the degree.
std::vector<double> intercept_weights(const std::vector<double>& x, int degree);

std::vector<double> mean_weights(std::size_t count);

}  // namespace sandglass
